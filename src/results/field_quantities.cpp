#include "results/field_quantities.hpp"

#include <string_view>

#include <fmt/format.h>

#include "io/display.hpp"

namespace breccia {
namespace {

/// A prefix for a picture: "µ" in place of "u".
std::string_view shown(std::string_view prefix) {
  return prefix == "u" ? "µ" : prefix;
}

std::string_view strain_of(Load load) {
  return load == Load::bulk ? "dilatation" : "shear strain";
}

/// A stress over the strain or stress applied, whose mean over the box is given.
FieldQuantity stress_over_load(std::string_view stress, Boundary boundary, Load load, double mean) {
  if (boundary == Boundary::traction) return {.words = fmt::format("{} over that applied", stress)};
  const auto [number, prefix, scale] = with_prefix(mean);
  return {.words = fmt::format("{} over mean {} in {}Pa", stress, strain_of(load), shown(prefix)), .unit_size = scale};
}

FieldQuantity strain_over_load(std::string_view strain, Load load, double mean) {
  return {.words = fmt::format("{} over mean {}", strain, strain_of(load)), .unit_size = mean};
}

}  // namespace

FieldQuantity stress_quantity(Boundary boundary, Load load, double mean) {
  return stress_over_load(load == Load::bulk ? "Mean in-plane stress" : "Shear stress", boundary, load, mean);
}

FieldQuantity strain_quantity(Load load, double mean) {
  return strain_over_load("Largest shear strain", load, mean);
}

FieldQuantity stress_in_space(Boundary boundary, Load load, double mean) {
  return stress_over_load(load == Load::bulk ? "Mean stress" : "Shear stress", boundary, load, mean);
}

FieldQuantity strain_in_space(Load load, double mean) {
  return strain_over_load("Equivalent shear strain", load, mean);
}

DrawnLoad drawn_load(Load load) {
  if (load == Load::bulk) return DrawnLoad::dilatation;
  return load == Load::shear ? DrawnLoad::shear : DrawnLoad::stretch;
}

std::string field_title(const Stage& stage, const TestId& test, double time) {
  const auto [number, prefix, scale] = with_prefix(time);
  return fmt::format("{}, {}, {}, {:.3g} {}s", stage.name, name_of(test.boundary),
                     test.method == Method::dynamic ? "dynamic" : "quasi-static", number, shown(prefix));
}

}  // namespace breccia
