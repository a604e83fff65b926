#include "breccia/virtual_test/modulus_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breccia {

ShearModulusBounds::ShearModulusBounds(const Discretisation<2>& discretisation,
                                       const std::vector<Material>& materials) {
  const auto fractions = discretisation.fractions(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (fractions[m] > 0.0) phases_.push_back({fractions[m], materials[m].bulk, materials[m].shear});
  }
}

double ShearModulusBounds::surrounded_by(double bulk, double shear, double time) const {
  // Sum of fraction / (G + G*) = 1 / (G_eff + G*) with G* = G kappa / (kappa + 2 G), kappa = K + G / 3
  // of the medium around (theory, Eq. 15).
  const double plane_bulk = bulk + shear / 3.0;
  const double surrounding = shear * plane_bulk / (plane_bulk + 2.0 * shear);
  double sum = 0.0;
  for (const auto& phase : phases_) sum += phase.fraction / (phase.shear.at(time) + surrounding);
  return 1.0 / sum - surrounding;
}

double ShearModulusBounds::lower(double time) const {
  double bulk = phases_.front().bulk.at(time), shear = phases_.front().shear.at(time);
  for (const auto& phase : phases_) {
    bulk = std::min(bulk, phase.bulk.at(time));
    shear = std::min(shear, phase.shear.at(time));
  }
  return surrounded_by(bulk, shear, time);
}

double ShearModulusBounds::upper(double time) const {
  double bulk = 0.0, shear = 0.0;
  for (const auto& phase : phases_) {
    bulk = std::max(bulk, phase.bulk.at(time));
    shear = std::max(shear, phase.shear.at(time));
  }
  return surrounded_by(bulk, shear, time);
}

double ShearModulusBounds::estimate(double time) const {
  return std::sqrt(lower(time) * upper(time));
}

}  // namespace breccia
