#include "microstructure/image/median_filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::Each;
using testing::ElementsAre;
using Values = std::vector<std::int32_t>;

TEST(MedianFilter, TakesTheMedianOfTheSquareAroundAPixel) {
  // The pixels around the middle one, sorted: 1 2 3 4 5 6 7 8 9. The corner at 1 sees 1 1 1 1 2 2 4 4 5.
  EXPECT_THAT(median_filtered(Values{1, 2, 3, 4, 5, 6, 7, 8, 9}, {3, 3, 1}, 3), ElementsAre(2, 3, 3, 4, 5, 6, 7, 7, 8));
}

TEST(MedianFilter, RemovesSinglePixelsAndKeepsStraightEdges) {
  Values values;
  for (int row = 0; row < 6; ++row) values.insert(values.end(), {0, 0, 0, 9, 9, 9});
  auto noisy = values;
  noisy[7] = 200;
  noisy[22] = -50;
  EXPECT_EQ(median_filtered(noisy, {6, 6, 1}, 3), values);
  EXPECT_EQ(median_filtered(noisy, {6, 6, 1}, 5), values);
}

TEST(MedianFilter, OfAStackTakesCubes) {
  Values values(27, 3);
  for (std::size_t voxel = 0; voxel < 13; ++voxel) values[voxel] = 8;  // 13 of 27 in the cube around the middle
  EXPECT_EQ(median_filtered(values, {3, 3, 3}, 3)[13], 3);
  values[13] = 8;
  EXPECT_EQ(median_filtered(values, {3, 3, 3}, 3)[13], 8);
}

TEST(MedianFilter, OfOneColumnRepeatsItsEnds) {
  EXPECT_THAT(median_filtered(Values{5, 1, 2}, {1, 3, 1}, 3), ElementsAre(5, 2, 2));
  EXPECT_THAT(median_filtered(Values{4}, {1, 1, 1}, 15), Each(4));
}

}  // namespace
}  // namespace breccia
