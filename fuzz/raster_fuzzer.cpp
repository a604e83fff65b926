// An image of labels. HDF5 is left out: its library is known to crash on hostile files.

#include "breccia/rasters/raster_reader.hpp"

#include "input_folder.hpp"
#include "io/text_file.hpp"
#include "refusal.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  using namespace breccia;
  static const fuzz::InputFolder folder;
  const auto bytes = fuzz::text_of(data, size);
  if (bytes.find("\x89HDF") != std::string_view::npos) return 0;
  const auto file = folder.path() / "image";
  std::filesystem::remove(file);  // writing over a file waits for the disk
  folder.write("image", bytes);
  fuzz::allow_refusal([&] {
    const auto raster = read_raster(file);
    std::size_t pixels = 1;
    for (const auto extent : raster.extents) pixels *= extent;
    if (pixels == 0 || pixels != raster.values.size()) throw std::logic_error("the values do not fill the image");
  });
  return 0;
}
