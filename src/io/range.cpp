#include "io/range.hpp"

#include <cmath>

#include <fmt/format.h>

namespace breccia {
namespace {

/// A noun with its article: "a length", "an integer".
std::string with_article(std::string_view noun) {
  const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

/// The description of a range: "a positive length", "a number between 0 and 1". `text_of` writes its limits.
template <class TextOf>
std::string described(const Range& range, std::string_view noun, const TextOf& text_of) {
  const bool bounded_below = std::isfinite(range.lower);
  const bool bounded_above = std::isfinite(range.upper);
  if (bounded_below && bounded_above) {
    const auto lower = text_of(range.lower), upper = text_of(range.upper);
    const auto limits = range.excludes_upper   ? fmt::format("between {} and {}", lower, upper)
                        : range.excludes_lower ? fmt::format("above {} and up to {}", lower, upper)
                                               : fmt::format("from {} to {}", lower, upper);
    return fmt::format("{} {}", with_article(noun), limits);
  }
  if (!bounded_below) return with_article(noun);
  if (range.lower == 0.0) return fmt::format("a {} {}", range.excludes_lower ? "positive" : "non-negative", noun);
  return fmt::format("{} of at least {}", with_article(noun), text_of(range.lower));
}

}  // namespace

bool accepts(const Range& range, double value) {
  const bool above = range.excludes_lower ? value > range.lower : value >= range.lower;
  const bool below = range.excludes_upper ? value < range.upper : value <= range.upper;
  return above && below && std::isfinite(value);
}

std::string described(const Range& range, std::string_view noun) {
  return described(range, noun, [](double limit) { return fmt::format("{}", limit); });
}

std::string described(const Range& range, Dimension dimension) {
  return described(range, name(dimension), [dimension](double limit) { return readable(limit, dimension); });
}

}  // namespace breccia
