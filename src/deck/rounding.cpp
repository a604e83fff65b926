#include "deck/rounding.hpp"

#include <charconv>

#include <fmt/format.h>

namespace breccia {

double as_typed(double value) {
  const auto digits = fmt::format("{:.12g}", value);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

}  // namespace breccia
