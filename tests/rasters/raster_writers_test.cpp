// Tests that labels are read back as Breccia has written them.

#include <array>
#include <filesystem>
#include <functional>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/rasters/raster_reader.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "rasters/npy.hpp"
#include "rasters/png.hpp"
#include "rasters/vti.hpp"
#include "temporary_directory.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Extents = std::vector<std::size_t>;
using Labels = std::vector<std::uint16_t>;

/// Labels without symmetry, among them the greatest.
Labels labels_for(const Extents& extents) {
  Labels labels(std::accumulate(extents.begin(), extents.end(), std::size_t{1}, std::multiplies<>()));
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = static_cast<std::uint16_t>(65535 - 7919 * i * i);
  return labels;
}

class RasterWriters : public testing::TestWithParam<Extents> {
 protected:
  void expect_read_back(const std::filesystem::path& file, std::string_view array = {}) const {
    const auto raster = read_raster(file, array);
    EXPECT_EQ(raster.extents, GetParam());
    EXPECT_EQ(raster.values, std::vector<std::int32_t>(labels.begin(), labels.end()));
  }

  const Labels labels = labels_for(GetParam());
  test::TemporaryDirectory directory;
};

TEST_P(RasterWriters, NumpyIsReadBack) {
  const auto file = directory.path() / "labels.npy";
  write_npy(file, GetParam(), labels);
  expect_read_back(file);
}

TEST_P(RasterWriters, VtiIsReadBack) {
  const auto file = directory.path() / "labels.vti";
  std::vector<std::int32_t> grains(labels.size());
  std::iota(grains.begin(), grains.end(), -2);
  write_vti(file, GetParam(), 1e-6,
            std::array<VtiArray, 2>{
                {{"phase", std::span<const std::uint16_t>(labels)}, {"grain", std::span<const std::int32_t>(grains)}}});
  expect_read_back(file);
  expect_read_back(file, "phase");
  EXPECT_EQ(read_raster(file, "grain").values, grains);
}

INSTANTIATE_TEST_SUITE_P(Shapes, RasterWriters,
                         testing::Values(Extents{1, 1}, Extents{5, 4}, Extents{3, 7}, Extents{300, 400},
                                         Extents{3, 4, 5}, Extents{60, 50, 70}),
                         test::by_value);

TEST(RasterWriter, PngOfPaletteIsReadBack) {
  const test::TemporaryDirectory directory;
  for (const std::size_t colours : {2U, 4U, 16U, 200U}) {
    std::vector<Rgb> palette(colours, {255, 0, 0});
    std::vector<std::uint8_t> from_top(15);
    std::iota(from_top.begin(), from_top.end(), 1);
    for (auto& number : from_top) number = static_cast<std::uint8_t>(number % colours);
    const auto raster = read_raster(directory.written("labels.png", encode_png(5, from_top, palette)));
    EXPECT_EQ(raster.extents, (Extents{5, 3}));
    std::vector<std::int32_t> upwards(from_top.begin() + 10, from_top.end());
    upwards.insert(upwards.end(), from_top.begin() + 5, from_top.begin() + 10);
    upwards.insert(upwards.end(), from_top.begin(), from_top.begin() + 5);
    EXPECT_EQ(raster.values, upwards) << colours;
  }
}

TEST(RasterWriter, NumpyHasTheTopRowFirst) {
  const test::TemporaryDirectory directory;
  const auto file = directory.path() / "labels.npy";
  write_npy(file, Extents{2, 2}, Labels{1, 2, 3, 258});
  const auto bytes = read_text(file);
  EXPECT_EQ(bytes.size(), 136U);
  EXPECT_THAT(bytes, StartsWith(std::string(
                         "\x93NUMPY\x01\0\x76\0{'descr': '<u2', 'fortran_order': False, 'shape': (2, 2), }", 69)));
  EXPECT_EQ(bytes.substr(128), std::string("\x03\0\x02\x01\x01\0\x02\0", 8));
}

TEST(RasterWriter, RefusesWhatDoesNotFit) {
  const test::TemporaryDirectory directory;
  const Labels labels(6);
  const std::array<VtiArray, 1> arrays{{{"phase", std::span<const std::uint16_t>(labels)}}};
  const auto npy = directory.path() / "labels.npy", vti = directory.path() / "labels.vti";
  EXPECT_THAT(test::message_of<InputError>([&] {
                write_npy(npy, Extents{2, 4}, labels);
              }),
              HasSubstr("labels.npy: 6 labels do not fill an image of 2 x 4"));
  EXPECT_THAT(test::message_of<InputError>([&] { write_npy(npy, Extents{6}, labels); }), HasSubstr("an image of 6"));
  EXPECT_THAT(test::message_of<InputError>([&] {
                write_vti(vti, Extents{2, 4}, 1.0, arrays);
              }),
              HasSubstr("labels.vti: array phase: expected 8 values, got 6"));
  EXPECT_THROW(write_vti(vti, Extents{2, 3}, 1.0, {}), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
  EXPECT_THROW(write_npy(directory.path() / "missing" / "labels.npy", Extents{2, 3}, labels), FileError);
}

}  // namespace
}  // namespace breccia
