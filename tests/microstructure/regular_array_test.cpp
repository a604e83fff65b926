#include "microstructure/regular_array.hpp"

#include <array>
#include <cstddef>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

TEST(RegularArray, ModelCompositeHasItsDiscsAtTheQuarterPoints) {
  const auto composite = regular_array<2>(6e-3, {2, 2}, 2e-3);
  ASSERT_EQ(composite.particles.size(), 4U);
  const std::array<Vector<2>, 4> quarter_points = {
      {{1.5e-3, 1.5e-3}, {4.5e-3, 1.5e-3}, {1.5e-3, 4.5e-3}, {4.5e-3, 4.5e-3}}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(composite.particles[k].diameter, 2e-3);
    for (std::size_t d = 0; d < 2; ++d) EXPECT_DOUBLE_EQ(composite.particles[k].centre[d], quarter_points[k][d]);
  }
  EXPECT_NEAR(smallest_gap(composite), 1e-3, 1e-15);
}

TEST(RegularArray, ColumnsAndRowsMayDiffer) {
  const auto array = regular_array<2>(12.0, {3, 4}, 2.5, Walls::periodic);
  ASSERT_EQ(array.particles.size(), 12U);
  EXPECT_EQ(array.particles[5].centre, (Vector<2>{10.0, 4.5}));
  EXPECT_EQ(array.walls, Walls::periodic);
  EXPECT_NO_THROW(require_valid(array));
  EXPECT_DOUBLE_EQ(smallest_gap(array), 0.5);
}

TEST(RegularArray, SpheresOnASimpleCubicLattice) {
  const auto array = regular_array<3>(12.0, {3, 4, 2}, 2.5, Walls::periodic);
  ASSERT_EQ(array.particles.size(), 24U);
  EXPECT_EQ(array.particles[17].centre, (Vector<3>{10.0, 4.5, 9.0}));
  EXPECT_NO_THROW(require_valid(array));
  EXPECT_DOUBLE_EQ(smallest_gap(array), 0.5);
  expect_error<InputError>([] { return regular_array<3>(6e-3, {3, 3, 3}, 2e-3); }, "3 x 3 x 3", "they touch");
}

TEST(RegularArray, BadArguments) {
  expect_error<InputError>([] { return regular_array<2>(6e-3, {3, 3}, 2e-3); }, "3 x 3", "they touch", "0.002 m");
  expect_error<InputError>([] { return regular_array<2>(6e-3, {0, 2}, 2e-3); }, "0 x 2");
  expect_error<InputError>([] { return regular_array<2>(0.0, {2, 2}, 2e-3); }, "side");
  expect_error<InputError>([] { return regular_array<2>(6e-3, {2, 2}, -2e-3); }, "positive diameter");
}

}  // namespace
}  // namespace breccia
