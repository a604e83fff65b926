#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breccia {

/// The header of a NumPy file (numpy.lib.format, versions 1 to 3).
struct NpyHeader {
  std::string type;                ///< such as "<u2": order of the bytes, kind, number of bytes
  bool fortran_order = false;      ///< the first index runs fastest, not the last
  std::vector<std::size_t> shape;  ///< number of elements along each index
  std::size_t size = 0;            ///< bytes before the numbers
};

/// Reads the header. Throws InputError if the file does not begin with one.
NpyHeader read_npy_header(const std::filesystem::path& file, std::string_view bytes);

}  // namespace breccia
