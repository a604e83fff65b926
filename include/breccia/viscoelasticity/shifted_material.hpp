#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/elastic_constants.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A material at a temperature, with the law by which it is shifted to others.
struct ShiftedMaterial {
  Material material;                           ///< material at the temperature of the shift
  std::optional<TemperatureShift> shift = {};  ///< nothing where no law is known
  /// Constants of a crystal, whose material has Hill's means of them; nothing for an isotropic material.
  std::optional<ElasticConstants> constants = {};
  std::optional<double> thermal_expansion = {};  ///< linear [1/K]; nothing where it is not given
};

/// Whether neither modulus of a material relaxes.
bool is_elastic(const Material& material);

/// The material of this name; nullptr where there is none.
const ShiftedMaterial* find_material(const std::vector<ShiftedMaterial>& materials, const std::string& name);

/// The material at another temperature [K]; an elastic material does not change. Throws InputError if no law is known
/// for a material that relaxes, or the temperature is outside the range of the law.
ShiftedMaterial at_temperature(ShiftedMaterial shifted, double temperature);

}  // namespace breccia
