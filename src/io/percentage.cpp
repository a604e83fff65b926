#include "io/percentage.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "io/trimmed.hpp"

namespace breccia {

std::optional<double> parse_percentage(std::string_view text) {
  text = detail::trimmed(text);
  if (!text.ends_with('%')) return std::nullopt;
  text = detail::trimmed(text.substr(0, text.size() - 1));
  double number = 0.0;
  const auto* const end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, number);
  if (error != std::errc{} || end != end_of_text || !std::isfinite(number)) return std::nullopt;
  // Rounded, so that "52.4 %" and 0.524 are the same number in spite of the division.
  const auto digits = fmt::format("{:.15g}", number / 100.0);
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace breccia
