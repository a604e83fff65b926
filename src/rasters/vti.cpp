#include "rasters/vti.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "rasters/zlib_stream.hpp"

namespace breccia {

namespace {

void append_header_number(std::string& bytes, std::uint64_t number) {
  for (unsigned shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(number >> shift);
}

/// An array in the form that VTK stores: number of blocks, their size, size of a smaller last block, compressed size of
/// each block, and the blocks.
std::string vti_blocks(std::string_view bytes) {
  constexpr std::size_t block_size = 1 << 18;
  std::string sizes, data;
  std::size_t blocks = 0;
  for (std::size_t begin = 0; begin < bytes.size(); begin += block_size, ++blocks) {
    const auto block = zlib_stream(bytes.substr(begin, block_size));
    append_header_number(sizes, block.size());
    data += block;
  }
  std::string stored;
  append_header_number(stored, blocks);
  append_header_number(stored, block_size);
  append_header_number(stored, bytes.size() % block_size);
  return stored + sizes + data;
}

template <class Number>
std::string_view type_name() {
  return std::is_same_v<Number, std::uint16_t> ? "UInt16" : "Int32";
}

}  // namespace

void write_vti(const std::filesystem::path& path, std::span<const std::size_t> extents, double pixel,
               std::span<const VtiArray> arrays) {
  static_assert(std::endian::native == std::endian::little, "values are written as they stand in the memory");
  const auto cells = std::accumulate(extents.begin(), extents.end(), std::size_t{1}, std::multiplies<>());
  if ((extents.size() != 2 && extents.size() != 3) || cells == 0 || arrays.empty()) {
    throw InputError(fmt::format("{}: {} arrays for an image of {} cells; expected at least one, in 2D or 3D",
                                 path.string(), arrays.size(), fmt::join(extents, " x ")));
  }
  std::string elements, appended;
  for (const auto& [name, values] : arrays) {
    std::visit(
        [&, &name = name]<class Number>(std::span<const Number> numbers) {
          if (numbers.size() != cells) {
            throw InputError(
                fmt::format("{}: array {}: expected {} values, got {}", path.string(), name, cells, numbers.size()));
          }
          elements += fmt::format(
              "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"1\" format=\"appended\" "
              "offset=\"{}\"/>\n",
              type_name<Number>(), name, appended.size());
          appended += vti_blocks({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()});
        },
        values);
  }
  const auto extent = fmt::format("0 {} 0 {} 0 {}", extents[0], extents[1], extents.size() == 3 ? extents[2] : 0);
  write_text(path, fmt::format("<?xml version=\"1.0\"?>\n"
                               "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                               "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
                               "  <ImageData WholeExtent=\"{0}\" Origin=\"0 0 0\" Spacing=\"{1} {1} {1}\">\n"
                               "    <Piece Extent=\"{0}\">\n"
                               "      <CellData Scalars=\"{2}\">\n{3}"
                               "      </CellData>\n"
                               "    </Piece>\n"
                               "  </ImageData>\n"
                               "  <AppendedData encoding=\"raw\">\n_",
                               extent, pixel, arrays.front().name, elements) +
                       appended + "\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace breccia
