#include "microstructure/image/image_sides.hpp"

#include <array>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Particles of 4, 2 and 3 pixels: the first is inside, the others touch a side; the last one has another label than
/// the pixel beside it, which is inside.
const LabelImage<2> particles = {{6, 6}, 1.0, Walls::periodic, {0, 0, 0, 0, 0, 0,  //
                                                                0, 1, 1, 0, 0, 0,  //
                                                                0, 1, 1, 0, 0, 1,  //
                                                                0, 0, 0, 0, 0, 1,  //
                                                                0, 0, 2, 1, 0, 0,  //
                                                                2, 2, 0, 0, 0, 0}};

TEST(ImageSides, CutTheParticlesThatTouchThem) {
  // 4 inside, 2 at the right, 2 at the bottom left; the pixel (2, 4) of filler 2 and (3, 4) of filler 1 are inside.
  EXPECT_DOUBLE_EQ(cut_share(particles), 4.0 / 10.0);
  auto joined = particles;
  joined.labels[26 - 2] = 2;  // (0, 4)
  joined.labels[25] = 2;      // joins (2, 4) with the side
  EXPECT_DOUBLE_EQ(cut_share(joined), 7.0 / 12.0);
  EXPECT_EQ(cut_share<2>({{2, 2}, 1.0, Walls::hard, {0, 0, 0, 0}}), 0.0);
  LabelImage<3> middle = {{3, 3, 3}, 1.0, Walls::hard, std::vector<Label>(27)};
  middle.labels[13] = 1;
  EXPECT_EQ(cut_share(middle), 0.0);
  middle.labels[4] = 1;
  EXPECT_EQ(cut_share(middle), 1.0);
}

TEST(ImageSides, FitTogetherWhereTheImageIsAPeriod) {
  // Stripes of two columns, once with a whole number of periods and once with one column less.
  const LabelImage<2> whole = {{4, 1}, 1.0, Walls::periodic, {0, 1, 1, 0}};
  EXPECT_TRUE(seam_of(whole).fits());
  const LabelImage<2> across = {{4, 4},
                                1.0,
                                Walls::hard,
                                {0, 0, 0, 1,  //
                                 0, 0, 0, 1,  //
                                 0, 0, 1, 1,  //
                                 0, 0, 1, 1}};
  const auto seam = seam_of(across);
  EXPECT_DOUBLE_EQ(seam.across, 1.0) << "all pixels of the left and the right side differ";
  EXPECT_DOUBLE_EQ(seam.most_inside, 0.5);
  EXPECT_FALSE(seam.fits());
}

TEST(ImageSides, MayHaveAFrameOfOneValue) {
  const std::array<std::size_t, 2> extents = {3, 4};
  const std::vector<std::int32_t> bar = {0, 0, 0, 7, 7, 7, 1, 2, 3, 4, 5, 6};
  EXPECT_EQ(frame_of(bar, extents), 2U) << "two rows, each of one value";
  const std::vector<std::int32_t> column = {1, 2, 9, 3, 4, 9, 5, 6, 9, 7, 8, 9};
  EXPECT_EQ(frame_of(column, extents), 1U);
  const std::vector<std::int32_t> none = {1, 2, 9, 3, 3, 3, 5, 6, 9, 7, 8, 0};
  EXPECT_EQ(frame_of(none, extents), 0U) << "a row inside";
  EXPECT_EQ(frame_of(std::vector<std::int32_t>(12, 4), extents), 0U) << "all of one value";
}

}  // namespace
}  // namespace breccia
