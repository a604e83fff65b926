#include "rasters/raster_format.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"

namespace breccia {

namespace {

using namespace std::string_view_literals;

/// The bytes with which the files of a format begin.
template <class Meaning>
struct Signature {
  std::string_view bytes;
  Meaning meaning;
};

constexpr std::array<Signature<RasterFormat>, 6> signatures = {{{"\x89PNG\r\n\x1a\n"sv, RasterFormat::png},
                                                                {"II*\0"sv, RasterFormat::tiff},
                                                                {"MM\0*"sv, RasterFormat::tiff},
                                                                {"II+\0"sv, RasterFormat::tiff},
                                                                {"MM\0+"sv, RasterFormat::tiff},
                                                                {"\x93NUMPY"sv, RasterFormat::npy}}};

/// Formats that a user may take for an image of labels, and the remedies.
constexpr std::array<Signature<std::string_view>, 6> refused = {
    {{"\xff\xd8\xff"sv, "a JPEG file, whose compression blurs labels"sv},
     {"GIF8"sv, "a GIF file"sv},
     {"BM"sv, "a Windows bitmap"sv},
     {"PK\x03\x04"sv, "a ZIP archive (.npz? numpy.save writes a .npy file)"sv},
     {"# vtk DataFile"sv, "a VTK file of the legacy format (ParaView saves it as .vti)"sv},
     {"MATLAB 5.0"sv, "a MATLAB file of version 7 (save with '-v7.3')"sv}}};

constexpr auto hdf5_signature = "\x89HDF\r\n\x1a\n"sv;

/// Whether a file is HDF5. It may begin with a user block of 512 bytes or more.
bool is_hdf5(std::string_view beginning) {
  for (std::size_t place = 0; place < beginning.size(); place = place == 0 ? 512 : 2 * place) {
    if (beginning.substr(place).starts_with(hdf5_signature)) return true;
  }
  return false;
}

template <class Signatures>
auto meaning_of(const Signatures& known, std::string_view beginning) {
  const auto* const found =
      std::ranges::find_if(known, [&](const auto& signature) { return beginning.starts_with(signature.bytes); });
  return found == known.end() ? std::nullopt : std::optional(found->meaning);
}

std::string unknown_content(std::string_view beginning) {
  constexpr std::size_t shown = 16;
  if (beginning.empty()) return "an empty file";
  if (const auto name = meaning_of(refused, beginning)) return std::string(*name);
  return fmt::format("a file that begins with {}", shown_value(beginning.substr(0, shown)));
}

}  // namespace

RasterFormat raster_format(const std::filesystem::path& file, std::string_view beginning) {
  if (const auto format = meaning_of(signatures, beginning)) return *format;
  if (is_hdf5(beginning)) return RasterFormat::hdf5;
  if (beginning.find("<VTKFile"sv) != std::string_view::npos) return RasterFormat::vti;
  throw InputError(fmt::format("{}: {}; expected an image: PNG, TIFF, NumPy .npy, VTK ImageData .vti or HDF5",
                               file.string(), unknown_content(beginning)));
}

}  // namespace breccia
