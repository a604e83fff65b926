#pragma once

#include <string>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// An isotropic linear viscoelastic solid: s(t) = 2 int G(t-t') de', p(t) = int K(t-t') d tr(eps').
struct Material {
  std::string name;
  double density = 0.0;  ///< [kg/m^3]
  PronySeries bulk;      ///< bulk modulus K(t) [Pa]
  PronySeries shear;     ///< shear modulus G(t) [Pa]

  friend bool operator==(const Material&, const Material&) = default;
};

/// The name of a void, which no other material has.
inline constexpr const char* name_of_void = "void";

/// A void: neither mass nor stiffness.
Material void_material();

/// Whether a material is a void.
bool is_void(const Material& material);

/// The modulus of equal strains along both axes in plane strain, K(t) + G(t)/3 [Pa]. It never rises with time, even
/// where K(t) of a composite does.
PronySeries plane_strain_bulk_modulus(const Material& material);

/// The modulus of equal strains along all axes [Pa]: K(t) + G(t)/3 in plane strain, K(t) in 3 dimensions. Instantiated
/// for 2 and 3 dimensions.
template <int dim>
PronySeries dilatational_series(const Material& material);

/// Speed of the dilatational wave before any relaxation, sqrt((K + 4 G / 3) / density) [m/s].
double dilatational_wave_speed(const Material& material);

/// Speed of a shear wave in a solid of given shear modulus [Pa] and density [kg/m^3], sqrt(G / density) [m/s].
double shear_wave_speed(double shear_modulus, double density);

/// The material with all relaxation times multiplied by a shift factor a_T > 0.
Material shifted(const Material& material, double shift_factor);

}  // namespace breccia
