// The saddle point of boxes with gaps: its operator against the assembled matrix, its preconditioners against their
// bounds, and its solver against sparse factors.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "parallel/session.hpp"
#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "quasistatic/solvers/saddle_point/cell_volumes.hpp"
#include "quasistatic/solvers/saddle_point/rigid_aggregates.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_solver.hpp"
#include "quasistatic/solvers/saddle_point/two_level_preconditioner.hpp"
#include "quasistatic/sphere_packings.hpp"

namespace breccia::quasistatic {
namespace {

constexpr int cells = 12;

/// Eight spheres with gaps from a twentieth of a cell on.
QuasistaticProblem<3> packing(double contrast, int cells_of_side = cells) {
  return test::spheres_with_gaps(test::sphere_packing("equal_52_008_a"), cells_of_side, contrast);
}

std::vector<Moduli> moduli_of(const QuasistaticProblem<3>& problem, double contrast) {
  EXPECT_EQ(problem.materials.size(), 2U);
  return {{.bulk = 1e4, .shear = 1.0}, {.bulk = 3.0 * contrast, .shear = contrast}};
}

ElasticOperator<3> operator_of(const QuasistaticProblem<3>& problem) {
  parallel::start();
  return {problem.discretisation, problem.volumetric, problem.boundary, 1, {}, problem.materials};
}

void set_random(std::span<double> values) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& value : values) value = uniform(generator);
}

TEST(CellVolumes, AreThoseOfTheModesOfCells) {
  using Shape = CellShape<3>;
  constexpr int in_row = 3;
  std::array<std::array<std::vector<double>, 4>, 3> rows;
  std::array<std::array<std::vector<double>, 4>, 3> on_rows;
  EdgeRows<const double> moved{};
  EdgeRows<double> exerted{};
  for (std::size_t component = 0; component < 3; ++component) {
    for (std::size_t edge = 0; edge < 4; ++edge) {
      rows[component][edge].resize(in_row + 1);
      set_random(rows[component][edge]);
      rows[component][edge][component] += static_cast<double>(edge);
      on_rows[component][edge].assign(in_row + 1, 0.0);
      moved[component][edge] = rows[component][edge].data();
      exerted[component][edge] = on_rows[component][edge].data();
    }
  }
  CellVolumes volumes(in_row);
  const auto strains = volumes.strains(moved);
  const auto modes = Shape::mode_matrix();
  for (std::size_t cell = 0; cell < in_row; ++cell) {
    Shape::Values u;
    for (std::size_t node = 0; node < Shape::nodes; ++node) {
      for (std::size_t component = 0; component < 3; ++component) {
        u[static_cast<Eigen::Index>(3 * node + component)] = rows[component][node >> 1U][cell + (node & 1U)];
      }
    }
    EXPECT_NEAR(strains[cell], modes.row(Shape::modes - 1).dot(u), 1e-14);
  }
  // The forces of a stress do the work of the stress on the strain.
  const std::array<double, in_row> stress = {2.0, -3.0, 5.0};
  volumes.add_forces(stress.data(), exerted);
  double work = 0.0, expected = 0.0;
  for (std::size_t component = 0; component < 3; ++component) {
    for (std::size_t edge = 0; edge < 4; ++edge) {
      for (std::size_t node = 0; node <= in_row; ++node) {
        work += rows[component][edge][node] * on_rows[component][edge][node];
      }
    }
  }
  for (std::size_t cell = 0; cell < in_row; ++cell) expected += stress[cell] * strains[cell];
  EXPECT_NEAR(work, expected, 1e-13);
}

TEST(SaddlePointOperator, IsTheStiffnessMatrixWhenPressuresAreEliminated) {
  constexpr double contrast = 1e3;
  const auto problem = packing(contrast);
  const auto elastic_operator = operator_of(problem);
  const auto moduli = moduli_of(problem, contrast);
  const auto w = elastic_operator.zero();
  {
    const WriteValues values(w.fluctuation());
    PetscInt size = 0;
    check(VecGetLocalSize(w.fluctuation(), &size), "reading a size");
    set_random({values.data(), static_cast<std::size_t>(size)});
  }
  elastic_operator.nodes().hold(w.fluctuation());
  const auto expected = elastic_operator.zero(), found = elastic_operator.zero();
  const auto matrix = elastic_operator.make_matrix();
  elastic_operator.assemble(moduli, matrix.get());
  check(MatMult(matrix.get(), w.fluctuation(), expected.fluctuation()), "multiplying");

  SaddlePointOperator saddle(elastic_operator);
  saddle.set_moduli(moduli);
  auto field = saddle.zeros(), product = saddle.zeros();
  saddle.boundary().read(w.fluctuation(), field);
  std::ranges::copy(saddle.layout().values(w.fluctuation()), saddle.gaps(field).begin());
  saddle.multiply(field, product);
  // B w - p / k = 0
  for (std::size_t cell = 0; cell < saddle.cells(); ++cell) {
    saddle.pressures(field)[cell] = saddle.bulk_of_pressures()[saddle.kinds()[cell]] * saddle.pressures(product)[cell];
  }
  saddle.multiply(field, product);
  double largest = 0.0;
  for (const double left : saddle.pressures(std::as_const(product))) largest = std::max(largest, std::abs(left));
  EXPECT_LT(largest, 1e-12);
  saddle.boundary().write(product, found.fluctuation());
  saddle.layout().set(saddle.gaps(product), found.fluctuation());
  elastic_operator.nodes().hold(found.fluctuation());
  auto difference = found.copy();
  difference.add(-1.0, expected);
  EXPECT_LT(std::sqrt(quasistatic::product(difference, difference)),
            1e-12 * std::sqrt(quasistatic::product(expected, expected)));
}

TEST(SaddlePointOperator, TakesNoBoxWithWalls) {
  auto problem = packing(1e3);
  problem.discretisation.set_particles_with_gaps(nullptr);  // which walls do not have in space
  problem.boundary = Boundary::displacement;
  const auto elastic_operator = operator_of(problem);
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(SaddlePointOperator(elastic_operator)); }),
              testing::HasSubstr("expected one process and a periodic boundary"));
}

/// A field of nodes whose sum vanishes, as that of the forces on a periodic box.
NodalField random_forces(const NodeLattice& lattice) {
  NodalField field(lattice);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double* component : field.components()) {
    double sum = 0.0;
    for_each_index(Index<3>{}, lattice.nodes, [&](const Index<3>& node) {
      const auto index = lattice.index_of(node);
      sum += component[index] = uniform(generator);
    });
    component[0] -= sum;
  }
  return field;
}

// Each application of a preconditioner with eigenvalues between 1/10 and 1 reduces the energy of an error to 0.81 at
// most; the solver counts on it.
TEST(TwoLevelPreconditioner, ReducesErrorsAtAnyContrast) {
  for (const double contrast : {1.0, 1e2, 1e4, 1e6}) {
    const auto problem = packing(contrast);
    // Without a contrast there would be no gaps.
    const auto elastic_operator = operator_of(packing(1e6));
    SaddlePointOperator saddle(elastic_operator);
    saddle.set_moduli(moduli_of(problem, contrast));
    TwoLevelPreconditioner preconditioner(saddle);
    const auto& lattice = saddle.lattice();
    LatticeSums sums(3 * lattice.size(), 1);
    // The error of a displacement whose exact value is zero.
    NodalField error(lattice), forces(lattice), step(lattice);
    preconditioner.apply(random_forces(lattice), error);
    const auto energy = [&] {
      saddle.multiply_similar(error, forces);
      return sums.product(error, forces);
    };
    const double before = energy();
    double last = before;
    constexpr int steps = 20;
    for (int k = 0; k < steps; ++k) {
      preconditioner.apply(forces, step);
      sums.add(error, -1.0, step);
      const double now = energy();
      EXPECT_LE(now, 0.81 * last) << contrast << ' ' << k;
      last = now;
    }
    EXPECT_LT(last, 1e-3 * before) << contrast;
  }
}

TEST(RigidAggregates, MoveAsRigidBodiesWithOrthonormalUnknowns) {
  const auto problem = packing(1e4);
  const auto elastic_operator = operator_of(problem);
  SaddlePointOperator saddle(elastic_operator);
  saddle.set_moduli(moduli_of(problem, 1e4));
  const auto& lattice = saddle.lattice();
  const RigidAggregates aggregates(lattice, saddle.similar_cells(), 4);
  // More than the 27 cubes, less than one for each node.
  EXPECT_GT(aggregates.unknowns(), 27 * 6);
  EXPECT_LT(aggregates.unknowns(), 3 * cells * cells * cells / 4);
  std::vector<double> unknowns(static_cast<std::size_t>(aggregates.unknowns())), back(unknowns.size());
  set_random(unknowns);
  NodalField moved(lattice);
  aggregates.prolong(unknowns, moved);
  aggregates.restrict_to(back, moved);
  for (std::size_t i = 0; i < unknowns.size(); ++i) EXPECT_NEAR(back[i], unknowns[i], 1e-12) << i;
  // A translation of all nodes is among their motions.
  NodalField translation(lattice), again(lattice);
  const auto everywhere = [&](const auto& action) {
    for_each_index(Index<3>{}, lattice.nodes, [&](const Index<3>& node) { action(lattice.index_of(node)); });
  };
  everywhere([&](std::size_t index) { translation.component(1)[index] = 1.0; });
  aggregates.restrict_to(back, translation);
  aggregates.prolong(back, again);
  everywhere([&](std::size_t index) { EXPECT_NEAR(again.component(1)[index], 1.0, 1e-12); });
}

TEST(SaddlePointSolver, FindsTheModuliOfFactors) {
  for (const double contrast : {1e2, 1e5}) {
    auto problem = packing(contrast);
    const auto by_factors = test::shear_moduli(problem);
    problem.linear.method = LinearMethod::iterative;
    const auto found = test::shear_moduli(problem);
    for (std::size_t load = 0; load < found.size(); ++load) {
      EXPECT_NEAR(found[load] / by_factors[load], 1.0, 1e-6) << contrast << ' ' << load;
    }
  }
}

/// The iterations of both loads.
int iterations(double contrast, int cells_of_side = cells) {
  auto problem = packing(contrast, cells_of_side);
  problem.linear.method = LinearMethod::iterative;
  problem.linear.threads = 1;
  const Moduli binder = {.bulk = 1e4, .shear = 1.0};
  return sample_responses(problem, std::array{Load::diagonal_shear, Load::shear}, matrix_path(0, std::array{binder}))
      .effort.iterations;
}

TEST(SaddlePointSolver, NeedsLittleMoreIterationsAtAHighContrast) {
  EXPECT_LT(iterations(1e5), 3 * iterations(1e2));
  EXPECT_LT(iterations(1e5), 1000);
}

TEST(SaddlePointSolver, NeedsLittleMoreIterationsOnAFinerGrid) {
  EXPECT_LT(iterations(1e4, 24), 1.5 * iterations(1e4));
}

TEST(SaddlePointSolver, GainsByASolutionAsGuessAndFindsNothingWithoutForces) {
  auto problem = packing(1e3);
  problem.linear.method = LinearMethod::iterative;
  const auto elastic_operator = operator_of(problem);
  const auto moduli = moduli_of(problem, 1e3);
  auto prescribed = elastic_operator.zero();
  prescribed.set_macroscopic(1.0);
  auto forces = forces_under(elastic_operator, moduli, prescribed, unit_strain<3>(Load::shear));
  forces.scale(-1.0);
  SaddlePointSolver solver(elastic_operator, problem.linear);
  solver.set_moduli(moduli);
  const double least = elastic_operator.volume();
  auto solution = solver.solve(forces.copy(), elastic_operator.zero(), least);
  const int iterations = solver.effort().iterations;
  EXPECT_GT(iterations, 0);
  solution = solver.solve(forces.copy(), std::move(solution), least);
  EXPECT_LT(solver.effort().iterations, 2 * iterations);
  const auto nothing = solver.solve(elastic_operator.zero(), std::move(solution), least);
  double largest = 0.0;
  check(VecNorm(nothing.fluctuation(), NORM_INFINITY, &largest), "reading the result");
  // The energy of the error is 1e-8 of that of the binder.
  EXPECT_LT(largest, 1e-3);
  EXPECT_EQ(solver.effort().solves, 3);
}

TEST(SaddlePointSolver, LeavesSmallBoxesToFactors) {
  auto problem = test::spheres_with_gaps(test::cubic_array("sc", 0.05), 6, 1e3);
  const auto by_factors = test::shear_moduli(problem);
  problem.linear.method = LinearMethod::iterative;
  EXPECT_EQ(test::shear_moduli(problem), by_factors);
}

TEST(SaddlePointSolver, FindsTheSameBitsWithAnyNumberOfThreads) {
  // Enough cells for several parts of each sum.
  auto problem = packing(1e3, 16);
  problem.linear.method = LinearMethod::iterative;
  problem.linear.threads = 1;
  const auto one = test::shear_moduli(problem);
  problem.linear.threads = 3;
  EXPECT_EQ(test::shear_moduli(problem), one);
}

}  // namespace
}  // namespace breccia::quasistatic
