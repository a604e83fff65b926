#include "report/embedded_pictures.hpp"

#include <stdexcept>

#include "breccia/rasters/raster_reader.hpp"

#include "rasters/base64.hpp"
#include "temporary_directory.hpp"

namespace breccia::test {

std::vector<Raster> embedded_pictures(std::string_view svg) {
  constexpr std::string_view begin = "data:image/png;base64,";
  const TemporaryDirectory directory;
  std::vector<Raster> pictures;
  for (auto at = svg.find(begin); at != std::string_view::npos; at = svg.find(begin, at)) {
    at += begin.size();
    const auto bytes = decode_base64(svg.substr(at, svg.find('"', at) - at));
    if (!bytes) throw std::runtime_error("a picture is not in base64");
    pictures.push_back(read_raster(directory.written("picture.png", *bytes)));
  }
  return pictures;
}

}  // namespace breccia::test
