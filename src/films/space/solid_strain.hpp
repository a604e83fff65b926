#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/films/film_problem.hpp"

namespace breccia::films {

using SolidGradients = Eigen::Matrix<double, 3, Eigen::Dynamic>;  ///< gradients of shape functions, a column each
using SolidStrainRows =
    Eigen::Matrix<double, 6, Eigen::Dynamic>;  ///< matrix that gives the strains in Voigt's order,
                                               ///< with engineering shears, from nodal displacements

/// Strain of nodal displacements, three components a node.
[[nodiscard]] inline SolidStrainRows solid_strain_rows(const SolidGradients& gradients) {
  SolidStrainRows rows = SolidStrainRows::Zero(6, 3 * gradients.cols());
  for (Eigen::Index node = 0; node < gradients.cols(); ++node) {
    const Eigen::Index u = 3 * node, v = u + 1, w = u + 2;
    rows(0, u) = rows(5, v) = rows(4, w) = gradients(0, node);
    rows(1, v) = rows(5, u) = rows(3, w) = gradients(1, node);
    rows(2, w) = rows(4, u) = rows(3, v) = gradients(2, node);
  }
  return rows;
}

/// Stress of a strain in Voigt's order, with engineering shears [Pa]: twice the energy is
/// K tr^2 + 2 G (eps : eps - tr^2 / 3).
[[nodiscard]] inline Eigen::Matrix<double, 6, 6> isotropic_stiffness(const Moduli& moduli) {
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
  stiffness.topLeftCorner<3, 3>().setConstant(moduli.bulk - 2.0 / 3.0 * moduli.shear);
  stiffness.diagonal().head<3>().array() += 2.0 * moduli.shear;
  stiffness.diagonal().tail<3>().setConstant(moduli.shear);
  return stiffness;
}

/// The elasticity of a grain [Pa].
[[nodiscard]] inline Eigen::Matrix<double, 6, 6> elasticity_of_grain(const FilmProblem<3>& problem, std::size_t grain) {
  return problem.crystals.empty() ? isotropic_stiffness(problem.grain) : problem.crystals[grain];
}

}  // namespace breccia::films
