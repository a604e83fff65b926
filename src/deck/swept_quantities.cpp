#include "deck/swept_quantities.hpp"

#include "io/units.hpp"

namespace breccia {

std::optional<SweptQuantity> swept_quantity(const Sweep& sweep, std::size_t key) {
  SweptQuantity swept;
  for (const auto& task : sweep.tasks) {
    const auto* text = std::get_if<std::string>(&task.values.at(key));
    const auto quantity = text != nullptr ? split_quantity(*text) : std::nullopt;
    if (!quantity || quantity->unit.empty()) return std::nullopt;
    if (swept.numbers.empty()) swept.unit = quantity->unit;
    const auto number = number_in_unit(*quantity, swept.unit);
    if (!number) return std::nullopt;
    swept.numbers.push_back(*number);
  }
  return swept;
}

}  // namespace breccia
