#include "breccia/viscoelasticity/material.hpp"

#include <cmath>

namespace breccia {

double dilatational_wave_speed(const Material& material) {
  return std::sqrt((material.bulk.unrelaxed() + 4.0 / 3.0 * material.shear.unrelaxed()) / material.density);
}

double shear_wave_speed(double shear_modulus, double density) {
  return std::sqrt(shear_modulus / density);
}

Material shifted(const Material& material, double shift_factor) {
  return {material.name, material.density, material.bulk.shifted(shift_factor), material.shear.shifted(shift_factor)};
}

}  // namespace breccia
