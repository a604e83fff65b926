#include "microstructure/image/image_lines.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Intercepts, AreRunsAlongAllAxes) {
  const LabelImage<2> image = {{4, 4},
                               1.0,
                               Walls::hard,
                               {1, 0, 0, 2,  //
                                1, 1, 0, 2,  //
                                0, 0, 0, 0,  //
                                1, 1, 1, 1}};
  // Rows: runs of filler 1, 1 | 2, 1 | none | 4; columns: 2, 1 | 1, 1 | 1 | 2, 1. Gaps in rows: 2 | 1, in columns: 1 |
  // 1 | none, as the third has matrix at its side | 1.
  const auto made = intercepts_of(image, 2.0);
  EXPECT_DOUBLE_EQ(made.mean_filler, (1 + 1 + 2 + 1 + 4 + 2 + 1 + 1 + 1 + 1 + 2 + 1) / 12.0);
  EXPECT_EQ(made.gaps, 5U);
  EXPECT_EQ(made.narrow_gaps, 4U);
  EXPECT_EQ(intercepts_of(image, 2.5).narrow_gaps, 5U);
  EXPECT_EQ(made.isolated_pixels, 0U);
}

TEST(Intercepts, TellIsolatedPixels) {
  LabelImage<2> image = {{5, 5}, 1.0, Walls::hard, std::vector<Label>(25)};
  image.labels[0] = 1;   // a corner
  image.labels[12] = 2;  // the middle
  EXPECT_EQ(intercepts_of(image, 1.0).isolated_pixels, 2U);
  image.labels[13] = 2;
  EXPECT_EQ(intercepts_of(image, 1.0).isolated_pixels, 1U);
  LabelImage<3> voxels = {{3, 3, 3}, 1.0, Walls::hard, std::vector<Label>(27)};
  voxels.labels[13] = 1;
  const auto made = intercepts_of(voxels, 1.0);
  EXPECT_EQ(made.isolated_pixels, 1U);
  EXPECT_DOUBLE_EQ(made.mean_filler, 1.0);
}

}  // namespace
}  // namespace breccia
