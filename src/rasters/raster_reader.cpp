#include "breccia/rasters/raster_reader.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/text_file.hpp"
#include "rasters/hdf5_raster.hpp"
#include "rasters/npy_reader.hpp"
#include "rasters/png_reader.hpp"
#include "rasters/raster_format.hpp"
#include "rasters/tiff_reader.hpp"
#include "rasters/vti_reader.hpp"

namespace breccia {

Raster read_raster(const std::filesystem::path& file, std::string_view array) {
  const auto format = raster_format(file, read_beginning(file, bytes_that_tell_format));
  const bool has_named_arrays = format == RasterFormat::hdf5 || format == RasterFormat::vti;
  if (!array.empty() && !has_named_arrays) {
    throw InputError(fmt::format("{}: no array {}; in a file of this format arrays have no names, expected none",
                                 file.string(), shown_value(array)));
  }
  if (format == RasterFormat::hdf5) return read_hdf5_raster(file, std::string(array));
  const auto bytes = read_text(file);
  switch (format) {
    case RasterFormat::png:
      return read_png(file, bytes);
    case RasterFormat::tiff:
      return read_tiff(file, bytes);
    case RasterFormat::npy:
      return read_npy(file, bytes);
    default:
      return read_vti(file, bytes, array.starts_with('/') ? array.substr(1) : array);
  }
}

RasterName raster_name(std::string_view text) {
  const auto colon = text.rfind(":/");
  if (colon == std::string_view::npos || colon == 0) return {text, {}};
  return {text.substr(0, colon), std::string(text.substr(colon + 1))};
}

}  // namespace breccia
