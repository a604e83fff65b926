#include "field_quantities.hpp"

#include <string_view>

#include <fmt/format.h>

#include "breccia/io/display.hpp"

namespace breccia {
namespace {

/// A prefix for a picture: "µ" in place of "u".
std::string_view shown(std::string_view prefix) {
  return prefix == "u" ? "µ" : prefix;
}

std::string_view strain_of(Load load) {
  return load == Load::bulk ? "dilatation" : "shear strain";
}

}  // namespace

FieldQuantity stress_quantity(Boundary boundary, Load load, double mean) {
  const std::string stress = load == Load::bulk ? "Mean in-plane stress" : "Shear stress";
  if (boundary == Boundary::traction) return {.words = stress + " over that applied"};
  const auto [number, prefix, scale] = with_prefix(mean);
  return {.words = fmt::format("{} over mean {} in {}Pa", stress, strain_of(load), shown(prefix)), .unit_size = scale};
}

FieldQuantity strain_quantity(Load load, double mean) {
  return {.words = fmt::format("Largest shear strain over mean {}", strain_of(load)), .unit_size = mean};
}

std::string field_title(const Stage& stage, const TestId& test, double time) {
  const auto [number, prefix, scale] = with_prefix(time);
  return fmt::format("{}, {}, {}, {:.3g} {}s", stage.name, bound_of(test.boundary),
                     test.method == Method::dynamic ? "dynamic" : "quasi-static", number, shown(prefix));
}

}  // namespace breccia
