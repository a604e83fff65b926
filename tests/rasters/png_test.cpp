#include "rasters/png.hpp"

#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using ::testing::ElementsAre;

constexpr std::array<Rgb, 3> palette = {{{255, 0, 0}, {0, 255, 0}, {1, 2, 3}}};

TEST(Png, HoldsItsPixels) {
  const auto file = encode_png(3, std::vector<std::uint8_t>{0, 1, 2, 2, 2, 0}, palette);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0) << image.message;
  EXPECT_EQ(image.width, 3U);
  EXPECT_EQ(image.height, 2U);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr), 0) << image.message;
  EXPECT_THAT(bytes, ElementsAre(255, 0, 0, 0, 255, 0, 1, 2, 3, 1, 2, 3, 1, 2, 3, 255, 0, 0));
}

TEST(Png, RefusesInvalidPixels) {
  EXPECT_THROW(static_cast<void>(encode_png(2, std::vector<std::uint8_t>{0, 1, 2}, palette)), InputError);
  EXPECT_THROW(static_cast<void>(encode_png(1, std::vector<std::uint8_t>{3}, palette)), InputError);
  EXPECT_THROW(static_cast<void>(encode_png(0, std::vector<std::uint8_t>{}, palette)), InputError);
}

}  // namespace
}  // namespace breccia
