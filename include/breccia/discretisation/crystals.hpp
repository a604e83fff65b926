#pragma once

#include <map>

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/discretisation/phase.hpp"
#include "breccia/discretisation/tensor.hpp"
#include "breccia/viscoelasticity/elastic_constants.hpp"

namespace breccia {

/// Stiffness C of an elastic solid [Pa]: its stress is C e for the strain e in Voigt's order with engineering shears.
/// It is symmetric, with 21 independent numbers in three dimensions and 6 in plane strain.
template <int dim>
using StiffnessTensor = Eigen::Matrix<double, tensor_components<dim>, tensor_components<dim>>;

/// The stiffness of each phase that is not isotropic, in the axes of the box [Pa]. In plane strain its part for the
/// strains in the plane acts, and the stress out of the plane follows.
using Crystals = std::map<PhaseIndex, StiffnessTensor<3>>;

/// The stiffness of an isotropic solid, in plane strain without strain out of the plane.
template <int dim>
[[nodiscard]] StiffnessTensor<dim> isotropic_stiffness(const Moduli& moduli);

/// The stiffness of a crystal in its own axes.
[[nodiscard]] StiffnessTensor<3> stiffness_tensor(const ElasticConstants& constants);

/// The axes of a crystal with Bunge's Euler angles [rad], as columns, in those of the box: the axes of the box are
/// turned about z by phi1, about the new x by phi and about the new z by phi2.
[[nodiscard]] Eigen::Matrix3d crystal_axes(double phi1, double phi, double phi2);

/// The stiffness, in the axes of the box, of a crystal whose axes are the columns of a rotation.
[[nodiscard]] StiffnessTensor<3> rotated(const StiffnessTensor<3>& stiffness, const Eigen::Matrix3d& axes);

/// The stiffness in plane strain: that for the strains xx, yy and xy without any other.
[[nodiscard]] StiffnessTensor<2> in_plane_strain(const StiffnessTensor<3>& stiffness);

/// The stiffness for the strains that a body of these dimensions may have: the whole in space, in_plane_strain() in the
/// plane.
template <int dim>
[[nodiscard]] StiffnessTensor<dim> stiffness_in(const StiffnessTensor<3>& stiffness) {
  if constexpr (dim == 2) {
    return in_plane_strain(stiffness);
  } else {
    return stiffness;
  }
}

/// Moduli of an aggregate of crystals without any texture [Pa]. No such aggregate is stiffer than the mean of the
/// stiffnesses (Voigt) or softer than that of the compliances (Reuss).
struct IsotropicMeans {
  double bulk_voigt, bulk_reuss, shear_voigt, shear_reuss;

  /// Hill's means of the two (1952).
  [[nodiscard]] double bulk() const { return 0.5 * (bulk_voigt + bulk_reuss); }
  [[nodiscard]] double shear() const { return 0.5 * (shear_voigt + shear_reuss); }
};

/// The isotropic means of a stiffness that is positive definite.
[[nodiscard]] IsotropicMeans isotropic_means(const StiffnessTensor<3>& stiffness);

/// The least eigenvalue of a symmetric stiffness in an orthonormal basis of the strains [Pa]: positive for a stable
/// solid. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] double least_stiffness(const StiffnessTensor<dim>& stiffness);

/// Moduli of an isotropic solid that stores no more energy than the given solid under any strain: twice its shear
/// modulus, and three times its bulk modulus, are the least eigenvalue of C in an orthonormal basis of the strains.
/// Throws InputError unless C is symmetric and positive definite. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Moduli softer_moduli(const StiffnessTensor<dim>& stiffness);

}  // namespace breccia
