#pragma once

#include <array>
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

/// A strain in Voigt's order with engineering shears.
template <int dim>
[[nodiscard]] Eigen::Vector<double, tensor_components<dim>> engineering_strain(const Strain<dim>& strain) {
  Eigen::Vector<double, tensor_components<dim>> engineering;
  for (int i = 0; i < tensor_components<dim>; ++i) engineering(i) = (i < dim ? 1.0 : 2.0) * component(strain, i);
  return engineering;
}

/// A phase that is not isotropic.
struct CrystalPhase {
  /// In the axes of the box [Pa]. In plane strain its part for the strains in the plane acts, and the stress out of the
  /// plane follows.
  StiffnessTensor<3> stiffness = StiffnessTensor<3>::Zero();
  PhaseIndex shown_as = no_phase;  ///< the phase that fields show in its place; no_phase: itself
};

/// The phases that are not isotropic, by their numbers.
using Crystals = std::map<PhaseIndex, CrystalPhase>;

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

/// The components, in Voigt's order in space, of the strain that a body of these dimensions may have, and of its
/// stress: in plane strain xx, yy, xy, and xx, yy, zz, xy.
template <int dim>
inline constexpr auto strain_components = std::array{0, 1, 2, 3, 4, 5};
template <>
inline constexpr auto strain_components<2> = std::array{0, 1, 5};
template <int dim>
inline constexpr auto stress_components = std::array{0, 1, 2, 3, 4, 5};
template <>
inline constexpr auto stress_components<2> = std::array{0, 1, 2, 5};

/// The stiffness for the strains that a body of these dimensions may have: the whole in space, that for the strains
/// xx, yy and xy in plane strain.
template <int dim>
[[nodiscard]] StiffnessTensor<dim> stiffness_in(const StiffnessTensor<3>& stiffness) {
  return stiffness(strain_components<dim>, strain_components<dim>);
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

/// A stiffness in an orthonormal basis of the strains, whose shears are root 2 times those of the tensor. Instantiated
/// for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] StiffnessTensor<dim> in_orthonormal_basis(StiffnessTensor<dim> stiffness);

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
