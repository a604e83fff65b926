// Tests of files that are cut off or damaged: they are refused, or read as an image; the program does not crash, and
// allocates no memory that the file cannot fill.

#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/rasters/raster_reader.hpp"

#include "io/text_file.hpp"
#include "temporary_directory.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

class DamagedRaster : public testing::TestWithParam<const char*> {
 protected:
  /// Reads the bytes as a file. Returns nothing if they are refused.
  std::optional<Raster> read(std::string_view bytes) {
    const auto file = directory_.path() / std::to_string(++files_);  // writing over a file would wait for the disk
    directory_.write(file.filename(), bytes);
    std::optional<Raster> raster;
    try {
      raster = read_raster(file);
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(file.string())) << error.what();
    }
    std::filesystem::remove(file);
    return raster;
  }

  const std::string bytes_ = read_text(std::filesystem::path(BRECCIA_TEST_IMAGES) / GetParam());

 private:
  test::TemporaryDirectory directory_;
  int files_ = 0;
};

class CutOffRaster : public DamagedRaster {};

TEST_P(CutOffRaster, IsRefusedUnlessAllNumbersAreThere) {
  constexpr std::size_t most_cuts = 300;
  const auto sound = read(bytes_).value();
  for (std::size_t length = 0; length < bytes_.size(); length += 1 + bytes_.size() / most_cuts) {
    EXPECT_EQ(read(bytes_.substr(0, length)).value_or(sound).values, sound.values) << length;
  }
}

class FlippedRaster : public DamagedRaster {};

TEST_P(FlippedRaster, IsRefusedOrRead) {
  const auto sound = read(bytes_).value();
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    auto damaged = bytes_;
    for (auto flips = 1 + random() % 3; flips > 0; --flips) {
      auto& byte = damaged[random() % damaged.size()];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << random() % 8));
    }
    EXPECT_FALSE(read(damaged).value_or(sound).values.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, CutOffRaster,
                         testing::Values("plane-interlaced.png", "plane-16bit.png", "plane-group4-mod2.tif",
                                         "plane-bigtiff.tif", "stack-tiled-deflate.tif", "plane-fortran.npy",
                                         "stack.npy", "plane-ascii.vti", "plane-inline-zlib.vti",
                                         "stack-two-base64.vti", "plane-raw-zlib.vti", "plane.h5"),
                         test::by_value);

// HDF5 is left out, because its library leaks memory when it refuses a damaged file.
INSTANTIATE_TEST_SUITE_P(Formats, FlippedRaster,
                         testing::Values("plane-interlaced.png", "plane-16bit.png", "plane-group4-mod2.tif",
                                         "plane-bigtiff.tif", "stack-tiled-deflate.tif", "plane-fortran.npy",
                                         "stack.npy", "plane-ascii.vti", "plane-inline-zlib.vti",
                                         "stack-two-base64.vti", "plane-raw-zlib.vti"),
                         test::by_value);

}  // namespace
}  // namespace breccia
