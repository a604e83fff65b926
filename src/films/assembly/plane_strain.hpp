#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/films/film_problem.hpp"

namespace breccia::films {

using Gradients = Eigen::Matrix<double, 2, Eigen::Dynamic>;   ///< gradients of shape functions, a column each
using StrainRows = Eigen::Matrix<double, 3, Eigen::Dynamic>;  ///< matrix that gives the strains xx, yy and the
                                                              ///< engineering shear from nodal displacements

/// Strain of nodal displacements, two components a node.
[[nodiscard]] inline StrainRows strain_rows(const Gradients& gradients) {
  StrainRows rows = StrainRows::Zero(3, 2 * gradients.cols());
  for (Eigen::Index node = 0; node < gradients.cols(); ++node) {
    rows(0, 2 * node) = rows(2, 2 * node + 1) = gradients(0, node);
    rows(1, 2 * node + 1) = rows(2, 2 * node) = gradients(1, node);
  }
  return rows;
}

/// Stress of a strain (xx, yy, engineering shear) in plane strain [Pa]: twice the energy is
/// K tr^2 + 2 G (eps : eps - tr^2 / 3).
[[nodiscard]] inline Eigen::Matrix3d plane_strain_stiffness(const Moduli& moduli) {
  const double diagonal = moduli.bulk + 4.0 / 3.0 * moduli.shear, off_diagonal = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  Eigen::Matrix3d stiffness;
  stiffness << diagonal, off_diagonal, 0.0, off_diagonal, diagonal, 0.0, 0.0, 0.0, moduli.shear;
  return stiffness;
}

/// The stress zz of a grain in plane strain, by unit strains xx, yy and xy [Pa].
[[nodiscard]] inline Eigen::Vector3d elasticity_out_of_plane(const FilmProblem<2>& problem, std::size_t grain) {
  if (!problem.crystals.empty()) {
    const auto& crystal = problem.crystals[grain];
    return {crystal(2, 0), crystal(2, 1), crystal(2, 5)};
  }
  const double first_lame = problem.grain.bulk - 2.0 / 3.0 * problem.grain.shear;
  return {first_lame, first_lame, 0.0};
}

/// The elasticity of a grain in plane strain [Pa].
[[nodiscard]] inline Eigen::Matrix3d elasticity_of_grain(const FilmProblem<2>& problem, std::size_t grain) {
  return problem.crystals.empty() ? plane_strain_stiffness(problem.grain) : stiffness_in<2>(problem.crystals[grain]);
}

}  // namespace breccia::films
