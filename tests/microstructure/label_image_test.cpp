#include "breccia/microstructure/label_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;
using testing::ElementsAre;

/// Three columns and two rows of pixels of 0.5 m; the lower row is 1 2 3.
LabelImage<2> plane(Walls walls) {
  return {{3, 2}, 0.5, walls, {1, 2, 3, 4, 5, 6}};
}

TEST(LabelImage, HasTheLabelOfThePixelAtAPoint) {
  const auto image = plane(Walls::hard);
  EXPECT_EQ(image.label_at({0.25, 0.25}), 1);
  EXPECT_EQ(image.label_at({1.25, 0.25}), 3);
  EXPECT_EQ(image.label_at({0.75, 0.75}), 5);
  EXPECT_EQ(image.label_at({0.5, 0.25}), 2);  // on a border
  EXPECT_EQ(image.label_at({0.0, 0.5}), 4);
}

TEST(LabelImage, OfThreeDimensionsHasLayers) {
  const LabelImage<3> image = {{1, 2, 3}, 1.0, Walls::hard, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(image.label_at({0.5, 1.5, 0.5}), 2);
  EXPECT_EQ(image.label_at({0.5, 0.5, 2.5}), 5);
  EXPECT_EQ(image.label_at({0.5, 1.5, 2.999}), 6);
}

TEST(LabelImage, ContinuesBeyondItsBox) {
  const auto hard = plane(Walls::hard), periodic = plane(Walls::periodic);
  EXPECT_EQ(hard.label_at({1.5, 1.0}), 6);  // the corner
  EXPECT_EQ(hard.label_at({-3.0, 7.0}), 4);
  EXPECT_EQ(periodic.label_at({1.5, 1.0}), 1);
  EXPECT_EQ(periodic.label_at({-0.25, 1.25}), 3);
  EXPECT_EQ(periodic.label_at({-1e-30, 0.25}), 3);
  EXPECT_EQ(periodic.label_at({1.75 + 3 * 1.5, 0.75 - 5 * 1.0}), 4);
}

TEST(LabelImage, EveryPixelOfALargeImageIsFoundAtItsCentre) {
  constexpr int count = 3000;
  LabelImage<2> image = {{count, 2}, 1e-6 / 3.0, Walls::periodic, {}};
  for (int i = 0; i < 2 * count; ++i) image.labels.push_back(static_cast<Label>(i));
  for (int i = 0; i < 2 * count; ++i) {
    const int column = i % count, row = i / count;
    const double x = (column + 0.5) * image.pixel_side, y = (row + 0.5) * image.pixel_side;
    ASSERT_EQ(image.label_at({x, y}), i);
  }
}

TEST(LabelImage, HasABox) {
  EXPECT_THAT(box_of(plane(Walls::hard)), ElementsAre(1.5, 1.0));
  EXPECT_FALSE(has_equal_sides(plane(Walls::hard)));
  EXPECT_TRUE(has_equal_sides(LabelImage<3>{{2, 2, 2}, 1.0, Walls::hard, std::vector<Label>(8)}));
  EXPECT_FALSE(has_equal_sides(LabelImage<3>{{2, 2, 1}, 1.0, Walls::hard, std::vector<Label>(4)}));
}

TEST(LabelImage, IsRefusedIfItIsNotWhole) {
  EXPECT_NO_THROW(require_valid(plane(Walls::hard)));
  auto image = plane(Walls::hard);
  image.labels.pop_back();
  expect_error<InputError>([&] { require_valid(image); }, "5 labels; expected 6 for 3 x 2 pixels");
  for (const double side : {0.0, -1e-6, std::numeric_limits<double>::infinity(), std::nan("")}) {
    image = plane(Walls::hard);
    image.pixel_side = side;
    expect_error<InputError>([&] { require_valid(image); }, "the side of a pixel must be positive");
  }
  expect_error<InputError>(
      [] {
        require_valid(LabelImage<3>{{2, 0, 2}, 1.0, Walls::hard, {}});
      },
      "2 x 0 x 2 pixels; expected at least one along each axis");
}

}  // namespace
}  // namespace breccia
