#include "page/page_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "breccia/error.hpp"

#include "rasters/base64.hpp"
#include "rasters/zlib_stream.hpp"

namespace breccia {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json bytes_for_page(std::span<const std::uint8_t> bytes) {
  return encode_base64(zlib_stream({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

Json numbers_for_page(const std::vector<double>& numbers) {
  if (numbers.empty()) return {{"from", 0.0}, {"to", 0.0}, {"values", bytes_for_page({})}};
  constexpr double most = 65535.0;
  if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
    throw FileError("a number that the page draws is not finite");
  }
  const auto [from, to] = std::ranges::minmax(numbers);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * numbers.size());
  for (const double number : numbers) {
    const double share = to > from ? (number - from) / (to - from) : 0.0;
    const auto level = static_cast<std::uint16_t>(std::lround(most * share));
    bytes.push_back(static_cast<std::uint8_t>(level & 0xffU));
    bytes.push_back(static_cast<std::uint8_t>(level >> 8U));
  }
  return {{"from", from}, {"to", to}, {"values", bytes_for_page(bytes)}};
}

}  // namespace breccia
