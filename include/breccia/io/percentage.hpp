#pragma once

#include <optional>
#include <string_view>

namespace breccia {

/// The fraction that a text in per cent stands for: "35 %" is 0.35. Nothing for any other text.
std::optional<double> parse_percentage(std::string_view text);

}  // namespace breccia
