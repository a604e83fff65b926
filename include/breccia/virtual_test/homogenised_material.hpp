#pragma once

#include <string>

#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A composite as an isotropic material, with the errors of the fit to its curves.
struct HomogenisedMaterial {
  Material material;
  TimeWindow fitted;         ///< time range of the fitted curves [s]
  double shear_error = 0.0;  ///< largest relative deviation of G(t) from its curve [-]
  double bulk_error = 0.0;   ///< largest relative deviation of K(t) + G(t)/3, or K(t) in 3D, from its curve [-]
};

/// Fits an isotropic material to the curves of a composite: its shear modulus to the curve G(t), and its modulus of
/// equal strains along all axes, K(t) in three dimensions, K(t) + G(t)/3 in plane strain, to the curve of the bulk
/// test. Both are fitted with non-negative Prony series (theory, Eqs. 32 and 33), so that the material dissipates
/// energy in the plane, even if K(t) = (K + G/3) - G/3 has negative terms. Since every term costs time and memory in
/// later stages, the relaxation times are spaced as widely as a thirtieth of the tolerance [-] on the relative
/// deviation from the curves allows (theory, Eq. 33a); a fit that cannot meet the tolerance is returned with its
/// errors. The density [kg/m^3] is that of the composite. Only the times of both curves are used; throws NumericalError
/// if there are fewer than three.
HomogenisedMaterial homogenised_material(const std::string& name, double density, const Curve& shear, const Curve& bulk,
                                         double tolerance, int dimensions = 2);

}  // namespace breccia
