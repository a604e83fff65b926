#pragma once

#include <optional>
#include <string_view>

namespace breccia {

/// The fraction given by a text in per cent: "35 %" is 0.35. Returns nothing for any other text.
std::optional<double> parse_percentage(std::string_view text);

}  // namespace breccia
