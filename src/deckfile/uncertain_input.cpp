#include "breccia/deckfile/uncertain_input.hpp"

#include <fmt/format.h>

namespace breccia {

std::size_t choices_of(const UncertainInput& input) {
  const auto* const choices = std::get_if<Choices>(&input.known);
  return choices == nullptr ? 0 : choices->values.size();
}

Scalar value_at(const UncertainInput& input, double coordinate) {
  if (const auto* const choices = std::get_if<Choices>(&input.known)) {
    return choices->values.at(static_cast<std::size_t>(coordinate));
  }
  const double value = value_at_score(std::get<Distribution>(input.known), coordinate);
  if (input.unit.empty()) return value;
  return fmt::format("{:.17g} {}", value, input.unit);
}

}  // namespace breccia
