#include "report/image_picture.hpp"

#include <array>
#include <cstddef>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/xml.hpp"

namespace breccia {
namespace {

using test::count;
using test::xml_mistake;
using ::testing::HasSubstr;

constexpr std::array<std::size_t, 3> colours = {0, 1, 2};

TEST(ImagePicture, IsWellFormedWithItsPixelsAndAScaleBar) {
  const auto picture = image_picture({{2, 2}, 1e-3, Walls::hard, {0, 1, 2, 0}}, colours);
  EXPECT_EQ(xml_mistake(picture), "");
  EXPECT_EQ(count(picture, "<image "), 1);
  EXPECT_THAT(picture, HasSubstr("Microstructure: an image of 2 x 2 pixels in a box of 2 mm"));
  EXPECT_THAT(picture, HasSubstr(R"(<image y="0" width="1000" height="1000" style="image-rendering: pixelated")"));
  EXPECT_THAT(picture, HasSubstr("500 µm"));
}

TEST(ImagePicture, OfManyPixelsShowsSquaresOfThem) {
  // 1003 pixels in squares of 2: the last one reaches half a square beyond the box.
  LabelImage<2> image = {{1003, 1003}, 1e-6, Walls::hard, std::vector<Label>(std::size_t{1003} * 1003, 1)};
  const auto picture = image_picture(image, colours);
  EXPECT_EQ(xml_mistake(picture), "");
  EXPECT_THAT(picture, HasSubstr(R"(<image y="-0.997009" width="1001" height="1001")"));
  EXPECT_THAT(picture, HasSubstr("1003 x 1003 pixels"));
}

TEST(ImagePicture, RefusesWhatItCannotDraw) {
  EXPECT_THROW(static_cast<void>(image_picture({{2, 1}, 1.0, Walls::hard, {0, 1}}, colours)), InputError);
  EXPECT_THROW(static_cast<void>(image_picture({{1, 1}, 1.0, Walls::hard, {3}}, colours)), InputError);
  EXPECT_THROW(static_cast<void>(image_picture({{1, 1}, 0.0, Walls::hard, {0}}, colours)), InputError);
}

}  // namespace
}  // namespace breccia
