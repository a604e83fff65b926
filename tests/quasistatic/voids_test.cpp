// Tests of voids, phases without stiffness, in cells of two and three dimensions, against conforming elements
// (tests/reference/void_arrays.csv) and against one another.

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr std::array tested_loads = {Load::shear, Load::diagonal_shear, Load::bulk};

/// A void in the middle of a periodic box of side 1.
template <int dim>
Discretisation<dim> array_of_voids(double fraction, int cells) {
  Microstructure<dim> box = {1.0, Walls::periodic, {}};
  Vector<dim> centre;
  centre.fill(0.5);
  const double diameter =
      dim == 2 ? 2.0 * std::sqrt(fraction / std::numbers::pi) : std::cbrt(6.0 * fraction / std::numbers::pi);
  box.particles.push_back({centre, diameter});
  constexpr std::array<PhaseIndex, 1> phase = {1};
  return discretise_mixed(box, cells, 0, phase, 2);
}

template <int dim>
QuasistaticProblem<dim> problem_of(Discretisation<dim> discretisation, Material matrix) {
  return {.discretisation = std::move(discretisation),
          .materials = {std::move(matrix), void_material()},
          .volumetric = Volumetric::averaged,
          .boundary = Boundary::periodic};
}

Material elastic(double bulk) {
  return {"matrix", 1.0, PronySeries(bulk), PronySeries(1.0)};
}

/// The moduli of a problem under the tested loads.
template <int dim>
std::vector<double> moduli_of(const QuasistaticProblem<dim>& problem) {
  const Moduli matrix = {.bulk = problem.materials[0].bulk.unrelaxed(),
                         .shear = problem.materials[0].shear.unrelaxed()};
  const auto sampled = sample_responses(problem, tested_loads, matrix_path(0, std::array{matrix}));
  std::vector<double> moduli;
  for (const auto& response : sampled.responses) moduli.push_back(response.modulus(matrix));
  return moduli;
}

/// Checks arrays of a fraction, and the limit of two grids, the second twice as fine, where the error is of first
/// order.
template <int dim>
void expect_reference(double fraction, int cells, double of_one_grid, double of_limit) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/void_arrays.csv", {"load"});
  const std::array<std::string, 3> names = {"xy", "xx-yy", "bulk"};
  int rows = 0;
  for (std::size_t row = 0; row < table.rows(); row += names.size()) {
    if (table.numbers("dimensions")[row] != dim || table.numbers("fraction")[row] != fraction) continue;
    const auto matrix = elastic(table.numbers("bulk_ratio")[row]);
    const auto coarse = moduli_of(problem_of(array_of_voids<dim>(fraction, cells), matrix));
    const auto fine = moduli_of(problem_of(array_of_voids<dim>(fraction, 2 * cells), matrix));
    for (std::size_t load = 0; load < names.size(); ++load) {
      ASSERT_EQ(table.text("load")[row + load], names[load]);
      const double exact = table.numbers("modulus")[row + load];
      EXPECT_NEAR(fine[load] / exact, 1.0, of_one_grid) << names[load] << ", K/G " << matrix.bulk.unrelaxed();
      EXPECT_NEAR((2.0 * fine[load] - coarse[load]) / exact, 1.0, of_limit) << names[load];
      ++rows;
    }
  }
  EXPECT_EQ(rows, 6);
}

TEST(Voids, InASquareArrayAreThoseOfConformingElements) {
  expect_reference<2>(0.2, 48, 0.008, 0.0035);
  expect_reference<2>(0.5, 48, 0.014, 0.007);
}

TEST(Voids, InACubicArrayAreThoseOfConformingElements) {
  expect_reference<3>(0.1, 16, 0.022, 0.02);
  expect_reference<3>(0.3, 16, 0.022, 0.02);
}

/// The moduli by sparse factors and by iterations.
template <int dim>
void expect_same_by_other_solver(double fraction, int cells) {
  auto problem = problem_of(array_of_voids<dim>(fraction, cells), elastic(20.0));
  problem.linear.method = LinearMethod::direct;
  const auto direct = moduli_of(problem);
  problem.linear.method = LinearMethod::iterative;
  const auto iterative = moduli_of(problem);
  for (std::size_t load = 0; load < direct.size(); ++load) EXPECT_NEAR(iterative[load] / direct[load], 1.0, 1e-6);
}

TEST(Voids, AreTheSameForAllSolvers) {
  expect_same_by_other_solver<2>(0.5, 40);
  expect_same_by_other_solver<3>(0.3, 10);
}

TEST(Voids, InAReducedResponseAreThoseOfSteps) {
  const Material relaxing = {"matrix", 1.0, PronySeries(20.0), PronySeries(1e-3, {{1.0, 0.999}})};
  const auto problem = problem_of(array_of_voids<2>(0.5, 24), relaxing);
  constexpr int per_decade = 40;
  const auto times = test::logarithmic(1e-3, 10.0, per_decade);
  const auto stepped = run_log_time_stepping(problem, tested_loads, times).responses;
  const auto sampled = sample_responses(problem, tested_loads, matrix_path(0, carson_path(relaxing, {1e-2, 10.0})));
  for (std::size_t load = 0; load < tested_loads.size(); ++load) {
    const auto modulus = relaxation_modulus(creep_compliance(sampled.responses[load], relaxing));
    for (std::size_t i = per_decade; i < times.size(); i += per_decade) {
      EXPECT_NEAR(stepped[load].values[i] / modulus.at(times[i]), 1.0, 1e-3) << times[i];
    }
  }
}

/// A layer of void across the box.
template <int dim>
void expect_no_stiffness_with_a_layer() {
  Grid<dim> grid{.cell_side = 0.1};
  grid.cells.fill(10);
  Discretisation<dim> discretisation(grid, 0);
  discretisation.paint([](const Vector<dim>& x) { return x[0] > 0.25 && x[0] < 0.45; }, 1);
  EXPECT_THROW((void)moduli_of(problem_of(std::move(discretisation), elastic(3.0))), InputError);
}

TEST(Voids, ThatPartTheSolidAreRefused) {
  expect_no_stiffness_with_a_layer<2>();
  expect_no_stiffness_with_a_layer<3>();
}

/// A piece of solid within a void moves with nothing.
TEST(Voids, HoldAPieceOfSolidWithoutEffect) {
  Grid<2> grid{.cells = {20, 20}, .cell_side = 0.05};
  Discretisation<2> empty(grid, 0);
  const auto within = [](double radius) {
    return [radius](const Vector<2>& x) { return std::hypot(x[0] - 0.5, x[1] - 0.5) < radius; };
  };
  empty.paint(within(0.35), 1);
  auto with_piece = empty;
  with_piece.paint(within(0.2), 0);
  const auto one = moduli_of(problem_of(std::move(empty), elastic(3.0)));
  const auto other = moduli_of(problem_of(std::move(with_piece), elastic(3.0)));
  for (std::size_t load = 0; load < one.size(); ++load) EXPECT_NEAR(other[load] / one[load], 1.0, 1e-7);
}

}  // namespace
}  // namespace breccia
