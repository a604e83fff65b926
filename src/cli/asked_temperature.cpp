#include "asked_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/io/units.hpp"

namespace breccia::cli {

AskedTemperature read_temperature(const std::string& text) {
  constexpr double zero_celsius = 273.15, smallest = 1e-6;
  const double kelvin = parse_quantity(text, Dimension::temperature);
  if (kelvin < 0.0) throw InputError(fmt::format("expected a temperature above absolute zero, got \"{}\"", text));
  const double celsius = std::round((kelvin - zero_celsius) / smallest) * smallest;
  return {kelvin, fmt::format("{:.6g} degC", celsius),
          fmt::format("respond-{}{:.6g}degC", celsius < 0.0 ? "minus" : "", std::abs(celsius))};
}

std::map<std::string, Material> materials_at(const std::vector<StoredMaterial>& materials,
                                             const std::vector<StoredResponses>& stored,
                                             const AskedTemperature& temperature) {
  std::map<std::string, Material> shifted;
  for (const auto& name : varying_materials(stored)) {
    const auto found = std::ranges::find(materials, name, [](const auto& each) { return each.material.name; });
    if (found == materials.end()) throw InputError(fmt::format("study.json has no material \"{}\"", name));
    auto material = at_temperature(*found, temperature.kelvin);
    material.name = fmt::format("{} at {}", name, temperature.name);
    shifted.insert_or_assign(name, std::move(material));
  }
  return shifted;
}

}  // namespace breccia::cli
