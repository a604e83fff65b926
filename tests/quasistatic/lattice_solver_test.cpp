// Tests of the iterative solver of cubes against sparse factors: where its iteration ends.
#include "quasistatic/solvers/lattice/lattice_solver.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "composites.hpp"
#include "discretisation/mixed_cells.hpp"
#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/solvers/direct/assembled_solver.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia::quasistatic {
namespace {

constexpr auto tested_load = Load::shear_yz;
constexpr Moduli stiff_phase = {.bulk = 2.0, .shear = 1.0};

/// A sphere in a box of side 1, with mixed cells.
Discretisation<3> sphere_in_a_box(int cells) {
  const Microstructure<3> box = {1.0, Walls::hard, {{{0.47, 0.52, 0.55}, 0.7}}};
  constexpr std::array<PhaseIndex, 1> of_sphere = {1};
  return discretise_mixed(box, cells, 0, of_sphere, 2);
}

/// The sphere in a matrix that is softer by a factor.
class SphereInSoftMatrix {
 public:
  SphereInSoftMatrix(Boundary boundary, double contrast)
      : operator_(sphere_in_a_box(8), Volumetric::averaged, boundary),
        moduli_{{.bulk = stiff_phase.bulk, .shear = stiff_phase.shear / contrast}, stiff_phase} {}

  [[nodiscard]] const ElasticOperator<3>& elastic_operator() const noexcept { return operator_; }
  /// Twice the energy of a box of the matrix under the load.
  [[nodiscard]] double least_energy() const { return moduli_.front().shear * operator_.volume(); }

  /// The fluctuation under the unit strain of the load, or the displacement under its tractions.
  [[nodiscard]] Displacement solve(ElasticSolver<3>& solver, std::optional<double> least_energy) const {
    solver.set_moduli(moduli_);
    solver.update_preconditioner();
    auto solution = solver.solve(forces(), operator_.zero(), least_energy);
    solution.set_macroscopic(0.0);
    return solution;
  }

  /// Twice the energy of the difference of two displacements.
  [[nodiscard]] double error(const Displacement& found, const Displacement& exact) const {
    auto difference = found.copy();
    difference.add(-1.0, exact);
    return work(forces_under(operator_, moduli_, difference, unit_strain<3>(tested_load)), difference);
  }
  [[nodiscard]] double energy(const Displacement& displacement) const {
    return work(forces_under(operator_, moduli_, displacement, unit_strain<3>(tested_load)), displacement);
  }

 private:
  /// The forces of the unit strain, or of a traction as large as that of the matrix under it.
  [[nodiscard]] Forces forces() const {
    if (operator_.boundary() == Boundary::traction) {
      auto tractions = operator_.load_forces(tested_load);
      tractions.scale(moduli_.front().shear);
      return tractions;
    }
    auto prescribed = operator_.zero();
    prescribed.set_macroscopic(1.0);
    auto forces = forces_under(operator_, moduli_, prescribed, unit_strain<3>(tested_load));
    forces.scale(-1.0);
    return forces;
  }

  ElasticOperator<3> operator_;
  std::vector<Moduli> moduli_;
};

Displacement by_factors(const SphereInSoftMatrix& box) {
  LinearOptions exact;
  exact.tolerance = 1e-13;
  AssembledSolver<3> solver(box.elastic_operator(), exact, Preconditioner::factors);
  return box.solve(solver, {});
}

// In a soft matrix the fluctuation has far more energy than the composite, whose energy must be accurate.
TEST(LatticeSolver, EndsWhereTheEnergyOfTheCompositeIsRight) {
  for (const auto boundary : {Boundary::periodic, Boundary::displacement}) {
    const SphereInSoftMatrix box(boundary, 1e8);
    const auto exact = by_factors(box);
    LatticeSolver solver(box.elastic_operator(), {});
    const auto by_fluctuation = box.solve(solver, {});
    EXPECT_LT(box.error(by_fluctuation, exact), 1e-12 * box.energy(exact)) << name_of(boundary);
    EXPECT_GT(box.error(by_fluctuation, exact), 1e-8 * box.least_energy()) << "the test has no sense";
    const auto found = box.solve(solver, box.least_energy());
    EXPECT_LT(box.error(found, exact), 1e-8 * box.least_energy()) << name_of(boundary);
  }
}

// The residual of the recurrence has drifted after so many iterations.
TEST(LatticeSolver, IsAccurateAfterThousandsOfIterations) {
  const SphereInSoftMatrix box(Boundary::displacement, 1e9);
  const auto exact = by_factors(box);
  LatticeSolver solver(box.elastic_operator(), {});
  const auto found = box.solve(solver, box.least_energy());
  EXPECT_LT(box.error(found, exact), 1e-8 * box.least_energy());
  EXPECT_GT(solver.effort().iterations, 1000);
}

// Tractions prescribe no displacement from which rounding errors could be estimated beforehand.
TEST(LatticeSolver, EndsAtRoundingUnderTractions) {
  const SphereInSoftMatrix box(Boundary::traction, 1e9);
  const auto exact = by_factors(box);
  LatticeSolver solver(box.elastic_operator(), {});
  const auto found = box.solve(solver, {});
  EXPECT_LT(box.error(found, exact), 1e-8 * box.energy(exact));
}

// Steps end by the same rule as the solutions of a reduced basis.
TEST(LatticeSolver, StepsThroughASofteningMatrixAsFactorsDo) {
  QuasistaticProblem<3> problem = {
      .discretisation = sphere_in_a_box(6),
      .materials = {{"matrix", 1.0, PronySeries(2.0), PronySeries(1e-7, {{1e-3, 0.1}})},
                    {"sphere", 1.0, PronySeries(stiff_phase.bulk), PronySeries(stiff_phase.shear)}},
      .boundary = Boundary::displacement};
  constexpr std::array loads = {tested_load};
  const auto times = test::logarithmic(1e-4, 1.0, 4);
  problem.linear.method = LinearMethod::direct;
  const auto expected = run_log_time_stepping(problem, loads, times).responses.front().values;
  problem.linear.method = LinearMethod::iterative;
  problem.linear.threads = 1;
  const auto found = run_log_time_stepping(problem, loads, times).responses.front().values;
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-4) << times[i];
}

}  // namespace
}  // namespace breccia::quasistatic
