#include "breccia/viscoelasticity/material.hpp"

#include <cmath>

namespace breccia {

Material void_material() {
  return {.name = name_of_void, .density = 0.0, .bulk = PronySeries(0.0), .shear = PronySeries(0.0)};
}

bool is_void(const Material& material) {
  return material.name == name_of_void && material.bulk.unrelaxed() == 0.0 && material.shear.unrelaxed() == 0.0;
}

PronySeries plane_strain_bulk_modulus(const Material& material) {
  return PronySeries::sum(material.bulk, material.shear.scaled(1.0 / 3.0));
}

template <>
PronySeries dilatational_series<2>(const Material& material) {
  return plane_strain_bulk_modulus(material);
}

template <>
PronySeries dilatational_series<3>(const Material& material) {
  return material.bulk;
}

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
