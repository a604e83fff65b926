#include "microstructure/image/image_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;
using testing::ElementsAre;

/// A square of 2 x 2 pixels in the lower left corner of 4 x 4 pixels of 0.5 m.
LabelImage<2> square(Walls walls) {
  return {{4, 4}, 0.5, walls, {1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
}

TEST(ImageStatistics, CountPixels) {
  EXPECT_THAT(label_fractions(square(Walls::hard), 3), ElementsAre(0.75, 0.25, 0.0));
  expect_error<InputError>([] { static_cast<void>(label_fractions(square(Walls::hard), 1)); },
                           "image: a pixel has the label 1, counted from 0, but there are only 1");
}

TEST(ImageStatistics, HaveTheLengthOfTheInterface) {
  EXPECT_DOUBLE_EQ(specific_interface(square(Walls::hard)), 2.0 / 4.0) << "two sides of 1 m, on 4 m^2";
  EXPECT_DOUBLE_EQ(specific_interface(square(Walls::periodic)), 4.0 / 4.0) << "all sides";
  // A layer has its two sides, and a box of one column no neighbours but itself.
  EXPECT_DOUBLE_EQ(specific_interface<2>({{1, 4}, 1.0, Walls::periodic, {0, 1, 1, 0}}), 2.0 / 4.0);
}

TEST(ImageStatistics, OfVoxelsHaveTheAreaOfTheInterface) {
  // One voxel of 2 x 2 x 2 voxels of 0.5 m has another label.
  LabelImage<3> corner = {{2, 2, 2}, 0.5, Walls::hard, {1, 0, 0, 0, 0, 0, 0, 0}};
  EXPECT_THAT(label_fractions(corner, 2), ElementsAre(0.875, 0.125));
  EXPECT_DOUBLE_EQ(specific_interface(corner), 3.0 * 0.25) << "three faces of 0.25 m^2, on 1 m^3";
  corner.walls = Walls::periodic;
  EXPECT_DOUBLE_EQ(specific_interface(corner), 6.0 * 0.25) << "all faces";
}

}  // namespace
}  // namespace breccia
