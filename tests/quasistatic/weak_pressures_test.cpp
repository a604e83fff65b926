// The coarse space of pressures that nodes hardly resist: exact in a homogeneous box, symmetric with gaps.

#include "quasistatic/solvers/saddle_point/weak_pressures.hpp"

#include <algorithm>
#include <cstddef>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "parallel/session.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"
#include "quasistatic/sphere_packings.hpp"

namespace breccia::quasistatic {
namespace {

constexpr int cells_of_side = 12;

ElasticOperator<3> operator_of_packing(bool has_gaps) {
  parallel::start();
  auto problem = test::spheres_with_gaps(test::sphere_packing("equal_52_008_a"), cells_of_side);
  if (!has_gaps) problem.discretisation.set_particles_with_gaps(nullptr);
  return {problem.discretisation, problem.volumetric, problem.boundary, 1, {}, problem.materials};
}

/// Pressures that alternate from cell to cell, or are uniform.
void set_pressures(const SaddlePointOperator& saddle, double even, double odd, NodalField& field) {
  std::size_t index = 0;
  for_each_index(Index<3>{}, saddle.lattice().own_cells(), [&](const Index<3>& cell) {
    saddle.pressures(field)[index++] = (cell[0] + cell[1] + cell[2]) % 2 == 0 ? even : odd;
  });
}

// No node feels such pressures, so that S is 1/k, up to the little that amplitudes have beside it.
TEST(WeakPressures, ResistByTheirBulkModulusAloneInAHomogeneousBox) {
  const auto elastic_operator = operator_of_packing(false);
  SaddlePointOperator saddle(elastic_operator);
  saddle.set_moduli(std::vector<Moduli>(2, {.bulk = 500.0, .shear = 1.0}));
  const WeakPressures weak(saddle);
  for (const double odd : {-1.0, 1.0}) {
    auto pressures = saddle.zeros(), volumes = saddle.zeros(), found = saddle.zeros();
    set_pressures(saddle, 1.0, odd, pressures);
    auto field = saddle.zeros();
    std::ranges::copy(pressures.all(), field.all().begin());
    saddle.multiply(field, volumes);
    for (const double force : volumes.all().first(saddle.first_pressure())) ASSERT_NEAR(force, 0.0, 1e-14);
    for (double& volume : saddle.pressures(volumes)) volume = -volume;
    weak.add_to(volumes, found);
    const auto expected = saddle.pressures(std::as_const(pressures));
    for (std::size_t cell = 0; cell < saddle.cells(); ++cell) {
      ASSERT_NEAR(saddle.pressures(found)[cell], expected[cell], 1e-5) << odd << ' ' << cell;
    }
  }
}

TEST(WeakPressures, AreSymmetricAndPositiveWithGaps) {
  const auto elastic_operator = operator_of_packing(true);
  SaddlePointOperator saddle(elastic_operator);
  saddle.set_moduli(std::vector<Moduli>{{.bulk = 1e4, .shear = 1.0}, {.bulk = 3e5, .shear = 1e5}});
  const WeakPressures weak(saddle);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  auto first = saddle.zeros(), second = saddle.zeros(), of_first = saddle.zeros(), of_second = saddle.zeros();
  for (auto* field : {&first, &second}) {
    for (double& volume : saddle.pressures(*field)) volume = uniform(generator);
  }
  weak.add_to(first, of_first);
  weak.add_to(second, of_second);
  LatticeSums sums(saddle.size(), 1);
  EXPECT_GT(sums.product(first, of_first), 0.0);
  const double work = sums.product(first, of_second);
  EXPECT_NEAR(sums.product(second, of_first), work, 1e-12 * std::abs(work));
  // Displacements and flows are left alone.
  for (const double value : of_first.all().first(saddle.first_pressure())) EXPECT_EQ(value, 0.0);
}

}  // namespace
}  // namespace breccia::quasistatic
