#include "breccia/viscoelasticity/shifted_material.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// Throws InputError if a factor takes a relaxation time of a material out of the range of numbers.
void require_finite_times(const Material& material, double factor, double temperature) {
  constexpr double largest = 1e100;
  for (const auto* series : {&material.bulk, &material.shear}) {
    for (const auto& term : series->terms()) {
      const double time = factor * term.relaxation_time;
      if (time > 1.0 / largest && time < largest) continue;
      throw InputError(
          fmt::format("{}: the temperature shift takes a relaxation time of {:.3g} s to {:.3g} s at {} K, which is "
                      "outside its range of use",
                      material.name, term.relaxation_time, time, temperature));
    }
  }
}

}  // namespace

bool is_elastic(const Material& material) {
  return material.bulk.is_elastic() && material.shear.is_elastic();
}

const ShiftedMaterial* find_material(const std::vector<ShiftedMaterial>& materials, const std::string& name) {
  for (const auto& one : materials) {
    if (one.material.name == name) return &one;
  }
  return nullptr;
}

ShiftedMaterial at_temperature(ShiftedMaterial shifted, double temperature) {
  auto& [material, shift, constants, expansion] = shifted;
  if (!is_elastic(material)) {
    if (!shift) {
      throw InputError(fmt::format(
          "{} has no temperature_shift in the deck of the study; give the material itself at that temperature",
          material.name));
    }
    const double factor = shift_factor(shift->law, temperature) / shift_factor(shift->law, shift->temperature);
    require_finite_times(material, factor, temperature);
    material = breccia::shifted(material, factor);
  }
  if (shift) shift->temperature = temperature;
  return shifted;
}

}  // namespace breccia
