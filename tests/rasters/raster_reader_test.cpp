#include "breccia/rasters/raster_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

using test::message_of;
using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

const std::filesystem::path images = BRECCIA_TEST_IMAGES;  // images of other programs, made by make.py

/// The values of make.py, whose rows count from the top, in the order of a raster.
std::vector<std::int32_t> values_of_make(int layers, int modulus) {
  constexpr int rows = 4, columns = 5;
  std::vector<std::int32_t> values;
  for (int layer = 0; layer < layers; ++layer) {
    for (int row = rows - 1; row >= 0; --row) {
      for (int column = 0; column < columns; ++column) {
        values.push_back((5 * layer + 7 * row + 3 * column) % 11 % modulus);
      }
    }
  }
  return values;
}

struct ImageOfAnotherProgram {
  std::string file;
  std::string array;
};

std::ostream& operator<<(std::ostream& stream, const ImageOfAnotherProgram& image) {
  return stream << image.file << ' ' << image.array;
}

class ReadRaster : public testing::TestWithParam<ImageOfAnotherProgram> {};

TEST_P(ReadRaster, FindsTheValuesOfAnotherProgram) {
  const auto& [file, array] = GetParam();
  const bool is_stack = file.starts_with("stack");
  const auto mod = file.find("-mod");
  const auto raster = read_raster(images / file, array);
  EXPECT_EQ(raster.extents, is_stack ? (std::vector<std::size_t>{5, 4, 3}) : (std::vector<std::size_t>{5, 4}));
  EXPECT_EQ(raster.values, values_of_make(is_stack ? 3 : 1, mod == std::string::npos ? 11 : file[mod + 4] - '0'));
}

/// All files that are not refused, without the name of an array where none is needed.
std::vector<ImageOfAnotherProgram> sound_images() {
  std::vector<ImageOfAnotherProgram> sound;
  for (const auto& entry : std::filesystem::directory_iterator(images)) {
    const auto name = entry.path().filename().string();
    if ((name.starts_with("plane") || name.starts_with("stack")) && name != "stack-two.h5") sound.push_back({name, ""});
  }
  sound.insert(sound.end(), {{"stack-two.h5", "/phase"},
                             {"stack-two.h5", "phase"},
                             {"plane.h5", "/image/labels"},
                             {"stack-two-base64.vti", "phase"},
                             {"stack-two-base64.vti", "/phase"},
                             {"plane-points.vti", "phase"}});
  std::ranges::sort(sound, {}, &ImageOfAnotherProgram::file);
  return sound;
}

/// Arrays are named by a path or without it.
std::string name_of_image(const testing::TestParamInfo<ImageOfAnotherProgram>& image) {
  const auto& [file, array] = image.param;
  auto name = test::as_test_name(file);
  if (array.empty()) return name;
  return name + (array.starts_with('/') ? "_path_" : "_array_") + test::as_test_name(array);
}

INSTANTIATE_TEST_SUITE_P(Files, ReadRaster, testing::ValuesIn(sound_images()), name_of_image);

TEST(ReadRasterFiles, AreAllThere) {
  EXPECT_EQ(sound_images().size(), 70U);
}

TEST(ReadRasterSideOfPixel, IsKnownWhereTheFileHasAUnit) {
  EXPECT_THAT(read_raster(images / "plane-2um.tif").pixel, Optional(DoubleNear(2e-6, 1e-12)));
  EXPECT_THAT(read_raster(images / "stack-imagej-500nm.tif").pixel, Optional(DoubleNear(500e-9, 1e-15)));
  EXPECT_EQ(read_raster(images / "plane-uint8.tif").pixel, std::nullopt);
  EXPECT_EQ(read_raster(images / "plane-grey.png").pixel, std::nullopt);
  EXPECT_EQ(read_raster(images / "plane-raw.vti").pixel, std::nullopt);  // its spacing has no unit
}

TEST(ReadRasterArray, OtherThanTheActiveOneIsFoundByName) {
  std::vector<std::int32_t> upwards(60);
  std::iota(upwards.begin(), upwards.end(), 0);
  EXPECT_EQ(read_raster(images / "stack-two-base64.vti", "grain").values, upwards);
  const auto from_top = read_raster(images / "stack-two.h5", "/grain").values;
  EXPECT_THAT(std::vector(from_top.begin(), from_top.begin() + 6), ElementsAre(15, 16, 17, 18, 19, 10));
}

TEST(RasterName, PartsFileAndArray) {
  const auto parts = [](std::string_view text) {
    const auto name = raster_name(text);
    return std::pair(name.file.string(), name.array);
  };
  EXPECT_EQ(parts("a/grains.h5:/labels/phase"), std::pair(std::string("a/grains.h5"), std::string("/labels/phase")));
  EXPECT_EQ(parts("grains.png"), std::pair(std::string("grains.png"), std::string()));
  EXPECT_EQ(parts("10:30.png"), std::pair(std::string("10:30.png"), std::string()));
}

class RefuseRaster : public testing::Test {
 protected:
  /// The message for an image of make.py, without its folder.
  static std::string message(const std::string& file, const std::string& array = {}) {
    const auto text = message_of<InputError>([&] { static_cast<void>(read_raster(images / file, array)); });
    EXPECT_THAT(text, testing::StartsWith((images / file).string()));
    return text.substr(std::min(images.string().size() + 1, text.size()));
  }
  [[nodiscard]] std::string message_for(std::string_view bytes) const {
    const auto file = directory.written("image", bytes);
    return message_of<InputError>([&] { static_cast<void>(read_raster(file)); });
  }

  test::TemporaryDirectory directory;
};

TEST_F(RefuseRaster, Colours) {
  EXPECT_EQ(message("bad-colours.png"),
            "bad-colours.png: a picture in colour; expected grey levels, or a palette whose numbers are the labels. It "
            "has 11 colours: (0, 249, 227) 10 %, (0, 255, 5) 10 %, (40, 254, 42) 10 %, (80, 247, 45) 10 %, (80, 253, "
            "79) 10 %, ...");
  EXPECT_THAT(message("bad-colours.tif"), HasSubstr("a picture in colour; expected grey levels"));
  EXPECT_EQ(message("bad-colours.npy"),
            "bad-colours.npy: an array of shape (16, 17, 3); it looks like a colour picture; expected labels, one "
            "number a pixel");
  EXPECT_EQ(message("bad-transparent.png"),
            "bad-transparent.png: a picture with transparent pixels; expected opaque ones");
}

TEST_F(RefuseRaster, ValuesThatAreNoLabels) {
  constexpr auto expected = "expected whole numbers from -2147483648 to 2147483647";
  EXPECT_THAT(message("bad-fraction.npy"), AllOf(HasSubstr("a pixel has the value 0.5"), HasSubstr(expected)));
  EXPECT_THAT(message("bad-fraction.tif"), AllOf(HasSubstr("a pixel has the value 0.5"), HasSubstr(expected)));
  EXPECT_THAT(message("bad-large.npy"), AllOf(HasSubstr("a pixel has the value 2147483648"), HasSubstr(expected)));
  EXPECT_THAT(message("bad-complex.npy"), HasSubstr("an array of the NumPy type \"<c8\"; expected booleans, integers"));
  EXPECT_THAT(message("bad-structured.npy"), HasSubstr("expected numbers; a structured array has several"));
  EXPECT_THAT(message("bad-text.h5"), HasSubstr("the data set \"/name\" holds no numbers"));
}

TEST_F(RefuseRaster, Shapes) {
  EXPECT_EQ(message("bad-line.npy"),
            "bad-line.npy: an array of shape (5); expected two dimensions, [y][x], or three, [z][y][x]");
  EXPECT_EQ(message("bad-empty.npy"), "bad-empty.npy: an image of 5 x 0 pixels; expected at least one along each axis");
  EXPECT_EQ(
      message("bad-pages.tif"),
      "bad-pages.tif: page 2: a picture of 5 x 3 pixels; expected 5 x 4 as on page 1, with rows in the same order");
  EXPECT_THAT(message("bad-channels.tif"),
              HasSubstr("an ImageJ stack with channels (3) or frames (1); expected one with slices alone"));
  EXPECT_THAT(message("bad-rotated.tif"), HasSubstr("page 1: a mirrored or rotated picture (orientation 6)"));
}

TEST_F(RefuseRaster, PixelsThatAreNoSquaresOrCubes) {
  EXPECT_EQ(message("bad-oblong.tif"),
            "bad-oblong.tif: page 1: the height of a pixel is 2 of its width; expected square pixels");
  EXPECT_EQ(message("bad-oblong.vti"), "bad-oblong.vti: Spacing=\"1 2 1\"; expected the same along all axes");
  EXPECT_EQ(message("bad-anisotropic.tif"),
            "bad-anisotropic.tif: page 1: layers lie 6 of a pixel's width apart; expected voxels that are cubes");
}

TEST_F(RefuseRaster, Arrays) {
  EXPECT_EQ(message("bad-two.vti"), "bad-two.vti: 2 arrays; expected the name of one of them: \"phase\", \"grain\"");
  EXPECT_EQ(message("bad-two.vti", "grian"),
            "bad-two.vti: no array \"grian\"; expected the name of one, did you mean \"grain\"?");
  EXPECT_EQ(message("stack-two.h5"), "stack-two.h5: 2 data sets; expected the name of one: /grain, /phase");
  EXPECT_EQ(message("stack-two.h5", "/grian"), "stack-two.h5: no data set \"/grian\", did you mean \"/grain\"?");
  EXPECT_EQ(message("plane-grey.png", "phase"),
            "plane-grey.png: no array \"phase\"; in a file of this format arrays have no names, expected none");
}

TEST_F(RefuseRaster, OtherFormats) {
  EXPECT_THAT(message("bad-jpeg.jpg"),
              HasSubstr("a JPEG file, whose compression blurs labels; expected an image: PNG"));
  EXPECT_THAT(message("bad-gif.gif"), HasSubstr("a GIF file"));
  EXPECT_THAT(message("bad-archive.npz"), HasSubstr("numpy.save writes a .npy file"));
  EXPECT_THAT(message("make.py"), HasSubstr("a file that begins with \"#!/usr/bin/pytho\"; expected an image"));
  EXPECT_THAT(message_for(""), HasSubstr("an empty file"));
  EXPECT_THAT(message_for("<?xml version=\"1.0\"?><VTKFile type=\"PImageData\"></VTKFile>"),
              HasSubstr("a VTK file of type \"PImageData\"; expected ImageData"));
}

TEST_F(RefuseRaster, FilesThatCannotBeRead) {
  const auto message_of_read = [&](const std::filesystem::path& file) {
    return message_of<FileError>([&] { static_cast<void>(read_raster(file)); });
  };
  EXPECT_THAT(message_of_read(directory.path() / "missing.png"), HasSubstr("missing.png: cannot read: No such file"));
  EXPECT_THAT(message_of_read(directory.path()), HasSubstr("it is a directory"));
}

/// A NumPy file of version 1 with this header, filled up with zeros.
std::string npy(const std::string& header, std::size_t bytes_of_numbers) {
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header +
         std::string(bytes_of_numbers, '\0');
}

TEST_F(RefuseRaster, NumpyHeadersWithMistakes) {
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3)}", 5)),
              HasSubstr("5 bytes of numbers; expected 6 for 6 pixels of type |u1"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3)}", 7)),
              HasSubstr("7 bytes of numbers; expected 6 for 6 pixels"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2147483648, 2147483648)}", 5)),
              HasSubstr("an image of 2147483648 x 2147483648 pixels; expected fewer than 2^29"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': False, 'shape': (99999999999999999999, 1)}", 5)),
              HasSubstr("a tuple of whole numbers for 'shape'"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': 0, 'shape': (2, 3)}", 6)),
              HasSubstr("True or False for 'fortran_order'"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'shape': (2, 3)}", 6)),
              HasSubstr("the keys 'descr', 'fortran_order' and 'shape'"));
  EXPECT_THAT(message_for(npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3)", 6)),
              HasSubstr("a closing brace"));
  EXPECT_THAT(message_for(npy("", 6)), HasSubstr("the header of this NumPy file is nothing"));
  EXPECT_THAT(message_for(std::string("\x93NUMPY\x04\0\x01\0", 10)), HasSubstr("version 4; expected 1, 2 or 3"));
  EXPECT_THAT(message_for(std::string("\x93NUMPY\x01\0\xff\0", 10)), HasSubstr("ends within its header"));
}

TEST_F(RefuseRaster, HugePngOfFewBytes) {
  // The file has a header for 20000 x 10000 grey levels, with its checksum, and no pixels.
  constexpr std::string_view bytes(
      "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x4e\x20\0\0\x27\x10\x08\0\0\0\0"
      "\xdc\x4f\x17\x7e"
      "\0\0\0\0IDAT",
      41);
  EXPECT_THAT(message_for(bytes),
              HasSubstr("the image would take 25000000 bytes, which a file of 41 bytes cannot hold"));
}

/// A .vti file of 2 x 1 cells with a cell array.
std::string vti(const std::string& array, const std::string& attributes = "byte_order=\"LittleEndian\"",
                const std::string& extent = "0 2 0 1 0 0") {
  return "<VTKFile type=\"ImageData\" " + attributes + ">\n<ImageData WholeExtent=\"" + extent +
         "\" Spacing=\"1 1 1\">\n<Piece Extent=\"" + extent + "\">\n<CellData>" + array +
         "</CellData>\n</Piece>\n</ImageData>\n</VTKFile>";
}

std::string ascii_array(const std::string& numbers, const std::string& attributes = "type=\"UInt8\"") {
  return R"(<DataArray Name="phase" format="ascii" )" + attributes + ">" + numbers + "</DataArray>";
}

TEST_F(RefuseRaster, VtiFilesWithMistakes) {
  const auto sound = vti(ascii_array("3 -4"));
  EXPECT_THAT(read_raster(directory.written("sound.vti", sound)).values, ElementsAre(3, -4));
  EXPECT_THAT(message_for(sound.substr(0, sound.size() - 20)), HasSubstr("image:6: damaged XML:"));
  EXPECT_THAT(message_for(vti(ascii_array("3"))), HasSubstr("an array of 1 number; expected 2 for the extent"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4 5"))), HasSubstr("an array of 3 numbers"));
  EXPECT_THAT(message_for(vti(ascii_array("3 matrix"))), HasSubstr("\"matrix\"; expected a number"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4.5"))), HasSubstr("a pixel has the value 4.5"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4", "type=\"String\""))), HasSubstr("an array of type \"String\""));
  EXPECT_THAT(message_for(vti(ascii_array("3 4", "type=\"UInt8\" NumberOfComponents=\"3\""))),
              HasSubstr("3 numbers a pixel in array \"phase\"; expected one"));
  EXPECT_THAT(message_for(vti("")), HasSubstr("no array; expected one, in CellData or PointData"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "byte_order=\"Middle\"")),
              HasSubstr("byte_order=\"Middle\"; expected \"LittleEndian\" or \"BigEndian\""));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "compressor=\"vtkLZ4DataCompressor\"")),
              HasSubstr("compressor=\"vtkLZ4DataCompressor\"; expected \"\" or \"vtkZLibDataCompressor\""));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "", "0 2 0 1")), HasSubstr("Extent=\"0 2 0 1\"; expected 6 numbers"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "", "0 2 0 0 0 0")), HasSubstr("an image of 2 x 0 x 1 pixels"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "", "2 0 0 1 0 0")), HasSubstr("expected whole numbers, in order"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "", "0 99999 0 99999 0 99999")),
              HasSubstr("expected fewer than 2^29"));
  EXPECT_THAT(message_for(vti(ascii_array("3 4"), "", "0 20000 0 20000 0 0")), HasSubstr("expected 400000000"));
  EXPECT_THAT(message_for(test::replaced(sound, "</ImageData>", "<Piece/></ImageData>")),
              HasSubstr("an image in 2 pieces"));
}

TEST_F(RefuseRaster, BinaryDataOfVtiFilesWithMistakes) {
  const auto binary = [](const std::string& text) {
    return R"(<DataArray type="UInt8" Name="phase" format="binary">)" + text + "</DataArray>";
  };
  // Four bytes with their number, 2, and the numbers 3 and 4.
  EXPECT_THAT(read_raster(directory.written("sound.vti", vti(binary("AgAAAAME")))).values, ElementsAre(3, 4));
  EXPECT_THAT(message_for(vti(binary("AgAAAAM="))), HasSubstr("1 byte of an array; expected 2"));
  EXPECT_THAT(message_for(vti(binary("AwAAAAME"))), HasSubstr("an array of 3 bytes; expected 2 for the extent"));
  EXPECT_THAT(message_for(vti(binary("AgAA"))), HasSubstr("an array that ends within its header"));
  EXPECT_THAT(message_for(vti(binary("AgAAAAM"))), HasSubstr("an array that is damaged or not base64"));
  EXPECT_THAT(message_for(vti(binary("Ag-AAAME"))), HasSubstr("an array that is damaged or not base64"));
  EXPECT_THAT(message_for(vti(binary("AgAAAAME"), "", "0 20000 0 20000 0 0")),
              HasSubstr("the image would take 400000000 bytes, which a file of"));
  EXPECT_THAT(message_for(vti("<DataArray type=\"UInt8\" Name=\"phase\" format=\"appended\" offset=\"0\"/>")),
              HasSubstr("an array whose offset is missing or beyond the end"));
}

}  // namespace
}  // namespace breccia
