#include "rasters/raster_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

template <class Number>
[[noreturn]] void refuse_value(const std::filesystem::path& file, Number number) {
  using Limits = std::numeric_limits<std::int32_t>;
  throw InputError(fmt::format("{}: a pixel has the value {}; expected whole numbers from {} to {}", file.string(),
                               number, Limits::min(), Limits::max()));
}

template <class Number>
std::int32_t whole_number(const std::filesystem::path& file, Number number) {
  if constexpr (std::is_floating_point_v<Number>) {
    const double value = number;
    const bool fits = value >= std::numeric_limits<std::int32_t>::min() &&
                      value <= std::numeric_limits<std::int32_t>::max() && value == std::trunc(value);
    if (!fits) refuse_value(file, number);
  } else {
    if (!std::in_range<std::int32_t>(number)) refuse_value(file, number);
  }
  return static_cast<std::int32_t>(number);
}

template <class Number>
Number number_at(const char* place, std::endian order) {
  std::array<char, sizeof(Number)> bytes{};
  std::memcpy(bytes.data(), place, bytes.size());
  if (order != std::endian::native) std::ranges::reverse(bytes);
  return std::bit_cast<Number>(bytes);
}

template <class Number>
void append_numbers(std::vector<std::int32_t>& values, const std::filesystem::path& file, std::string_view bytes,
                    std::endian order) {
  for (; bytes.size() >= sizeof(Number); bytes.remove_prefix(sizeof(Number))) {
    values.push_back(whole_number(file, number_at<Number>(bytes.data(), order)));
  }
  if (!bytes.empty()) throw InputError(fmt::format("{}: it ends within a number", file.string()));
}

}  // namespace

void append_elements(std::vector<std::int32_t>& values, const std::filesystem::path& file, std::string_view bytes,
                     const ElementType& type) {
  const auto append = [&]<class Number>(Number) { append_numbers<Number>(values, file, bytes, type.order); };
  const auto append_by_size = [&](auto one, auto two, auto four, auto eight) {
    switch (type.bytes) {
      case sizeof(one):
        return append(one);
      case sizeof(two):
        return append(two);
      case sizeof(four):
        return append(four);
      case sizeof(eight):
        return append(eight);
      default:
        throw InputError(fmt::format("{}: numbers of {} bytes; expected 1, 2, 4 or 8", file.string(), type.bytes));
    }
  };
  switch (type.kind) {
    case ElementType::Kind::signed_integer:
      return append_by_size(std::int8_t{}, std::int16_t{}, std::int32_t{}, std::int64_t{});
    case ElementType::Kind::unsigned_integer:
      return append_by_size(std::uint8_t{}, std::uint16_t{}, std::uint32_t{}, std::uint64_t{});
    case ElementType::Kind::floating_point:
      return type.bytes == sizeof(float) ? append(float{}) : append(double{});
  }
}

std::int32_t raster_value(const std::filesystem::path& file, double number) {
  return whole_number(file, number);
}

void append_packed(std::vector<std::int32_t>& values, std::string_view bytes, std::size_t count, unsigned bits) {
  const auto per_byte = 8 / bits;
  const auto mask = (1U << bits) - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i / per_byte]);
    const auto shift = 8 - bits * (i % per_byte + 1);
    values.push_back(static_cast<std::int32_t>((byte >> shift) & mask));
  }
}

}  // namespace breccia
