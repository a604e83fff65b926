#pragma once

#include <string>

#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A composite as an isotropic material, and how well that describes its curves.
struct HomogenisedMaterial {
  Material material;
  TimeWindow fitted;         ///< in which the material stands for the composite [s]
  double shear_error = 0.0;  ///< largest relative deviation of G(t) from the curve there [-]
  double bulk_error = 0.0;   ///< the same of K(t) + G(t)/3 [-]
};

/// The material whose shear modulus follows the curve G(t) and whose answer to an equibiaxial strain in the plane,
/// K(t) + G(t)/3, follows the curve of the plane-strain bulk modulus: both fitted with non-negative Prony series
/// (theory, Eqs. 32 and 33), so that in the plane the material dissipates, whatever the sign of what K(t) = (K + G/3) -
/// G/3 does alone. Since every term costs time and memory in the stages that build on the material, the relaxation
/// times are spaced as widely as a thirtieth of the tolerance [-] on the relative deviation from the curves allows
/// (theory, Eq. 33a); a fit that cannot meet the tolerance is returned as it is, with its errors. The density [kg/m^3]
/// is that of the composite. The times of the two curves that are the same count; throws NumericalError where they are
/// fewer than three.
HomogenisedMaterial homogenised_material(const std::string& name, double density, const Curve& shear,
                                         const Curve& plane_strain_bulk, double tolerance);

}  // namespace breccia
