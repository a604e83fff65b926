#include "breccia/virtual_test/modulus_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "discretisation/contrast.hpp"

namespace breccia {

namespace {

/// The term G kappa / (kappa + 2 G) of the surrounding medium with kappa = K + G / 3 (theory, Eq. 15).
double surrounding_in_plane_strain(double bulk, double shear) {
  const double plane_bulk = bulk + shear / 3.0;
  return shear * plane_bulk / (plane_bulk + 2.0 * shear);
}

/// The term of the surrounding medium in three dimensions (theory, Eq. 15a).
double surrounding_in_space(double bulk, double shear) {
  return shear * (9.0 * bulk + 8.0 * shear) / (6.0 * (bulk + 2.0 * shear));
}

}  // namespace

template <int dim>
ShearModulusBounds::ShearModulusBounds(const Discretisation<dim>& discretisation,
                                       const std::vector<Material>& materials)
    : surrounding_(dim == 2 ? surrounding_in_plane_strain : surrounding_in_space) {
  const auto fractions = discretisation.fractions(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (fractions[m] > 0.0) phases_.push_back({fractions[m], materials[m].bulk, materials[m].shear});
  }
}

double ShearModulusBounds::surrounded_by(double bulk, double shear, double time) const {
  // The equation is: sum of fraction / (G + G*) = 1 / (G_eff + G*).
  const double surrounding = surrounding_(bulk, shear);
  double sum = 0.0;
  for (const auto& phase : phases_) sum += phase.fraction / (phase.shear.at(time) + surrounding);
  return 1.0 / sum - surrounding;
}

double ShearModulusBounds::lower(double time) const {
  std::vector<Moduli> moduli;
  for (const auto& phase : phases_) moduli.push_back({.bulk = phase.bulk.at(time), .shear = phase.shear.at(time)});
  const auto [bulk, shear] = least_of_solids(moduli);
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

template ShearModulusBounds::ShearModulusBounds(const Discretisation<2>&, const std::vector<Material>&);
template ShearModulusBounds::ShearModulusBounds(const Discretisation<3>&, const std::vector<Material>&);

}  // namespace breccia
