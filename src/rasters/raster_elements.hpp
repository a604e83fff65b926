#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace breccia {

/// The representation of a number in a file.
struct ElementType {
  enum class Kind { signed_integer, unsigned_integer, floating_point };

  Kind kind = Kind::unsigned_integer;
  std::size_t bytes = 1;  ///< number of bytes: 1, 2, 4 or 8; for floating point 4 or 8
  std::endian order = std::endian::native;
};

/// Appends the numbers in some bytes to the values of a raster. Throws InputError if the last one is cut, or if one is
/// not whole or does not fit.
void append_elements(std::vector<std::int32_t>& values, const std::filesystem::path& file, std::string_view bytes,
                     const ElementType& type);

/// The value of a raster for a number of another type, by the rules of append_elements().
std::int32_t raster_value(const std::filesystem::path& file, double number);

/// Appends the first `count` numbers of `bits` (1, 2 or 4) each in some bytes; the first is in the highest bits.
void append_packed(std::vector<std::int32_t>& values, std::string_view bytes, std::size_t count, unsigned bits);

}  // namespace breccia
