#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

namespace breccia {

/// Bytes for the page: compressed by zlib, in base64.
nlohmann::ordered_json bytes_for_page(std::span<const std::uint8_t> bytes);

/// Numbers for the page in two bytes each, the lower byte first, scaled from 0 at the smallest number, `from`, to 65535
/// at the largest, `to`: {"from": ..., "to": ..., "values": bytes}. Throws FileError when one is not finite.
nlohmann::ordered_json numbers_for_page(const std::vector<double>& numbers);

}  // namespace breccia
