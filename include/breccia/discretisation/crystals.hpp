#pragma once

#include <map>

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/discretisation/phase.hpp"
#include "breccia/discretisation/tensor.hpp"

namespace breccia {

/// Stiffness C of an elastic solid [Pa]: its stress is C e for the strain e in Voigt's order with engineering shears.
/// It is symmetric, with 21 independent numbers in three dimensions and 6 in plane strain.
template <int dim>
using StiffnessTensor = Eigen::Matrix<double, tensor_components<dim>, tensor_components<dim>>;

/// The stiffness of each phase that is not isotropic.
template <int dim>
using Crystals = std::map<PhaseIndex, StiffnessTensor<dim>>;

/// The stiffness of an isotropic solid, in plane strain without strain out of the plane.
template <int dim>
[[nodiscard]] StiffnessTensor<dim> isotropic_stiffness(const Moduli& moduli);

/// Moduli of an isotropic solid that stores no more energy than the given solid under any strain: twice its shear
/// modulus, and three times its bulk modulus, are the least eigenvalue of C in an orthonormal basis of the strains.
/// Throws InputError unless C is symmetric and positive definite. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Moduli softer_moduli(const StiffnessTensor<dim>& stiffness);

}  // namespace breccia
