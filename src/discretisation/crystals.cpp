#include "breccia/discretisation/crystals.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

template <int dim>
StiffnessTensor<dim> isotropic_stiffness(const Moduli& moduli) {
  StiffnessTensor<dim> stiffness = StiffnessTensor<dim>::Zero();
  stiffness.template topLeftCorner<dim, dim>().setConstant(moduli.bulk - 2.0 / 3.0 * moduli.shear);
  stiffness.template topLeftCorner<dim, dim>().diagonal().array() += 2.0 * moduli.shear;
  constexpr int shears = tensor_components<dim> - dim;
  stiffness.template bottomRightCorner<shears, shears>().diagonal().setConstant(moduli.shear);
  return stiffness;
}

StiffnessTensor<3> stiffness_tensor(const ElasticConstants& constants) {
  StiffnessTensor<3> stiffness;
  for (std::size_t i = 1; i <= 6; ++i) {
    for (std::size_t j = 1; j <= 6; ++j) {
      stiffness(static_cast<Eigen::Index>(i) - 1, static_cast<Eigen::Index>(j) - 1) =
          constants[place_of_constant(i, j)];
    }
  }
  return stiffness;
}

Eigen::Matrix3d crystal_axes(double phi1, double phi, double phi2) {
  using Eigen::Vector3d;
  return (Eigen::AngleAxisd(phi1, Vector3d::UnitZ()) * Eigen::AngleAxisd(phi, Vector3d::UnitX()) *
          Eigen::AngleAxisd(phi2, Vector3d::UnitZ()))
      .toRotationMatrix();
}

StiffnessTensor<3> rotated(const StiffnessTensor<3>& stiffness, const Eigen::Matrix3d& axes) {
  // The columns are the stresses in the box of unit stresses in the crystal: the matrix M of Bond (1943), with which
  // C' = M C M'.
  constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};
  StiffnessTensor<3> bond;
  for (std::size_t row = 0; row < pairs.size(); ++row) {
    const auto [i, j] = pairs[row];
    for (std::size_t column = 0; column < pairs.size(); ++column) {
      const auto [k, l] = pairs[column];
      const double once = axes(i, k) * axes(j, l);
      bond(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          k == l ? once : once + axes(i, l) * axes(j, k);
    }
  }
  return bond * stiffness * bond.transpose();
}

template <int dim>
StiffnessTensor<dim> in_orthonormal_basis(StiffnessTensor<dim> stiffness) {
  // Engineering shears are root 2 times the coordinates in an orthonormal basis.
  constexpr int shears = tensor_components<dim> - dim;
  stiffness.template bottomRows<shears>() *= std::sqrt(2.0);
  stiffness.template rightCols<shears>() *= std::sqrt(2.0);
  return stiffness;
}

template <int dim>
double least_stiffness(const StiffnessTensor<dim>& stiffness) {
  const Eigen::SelfAdjointEigenSolver<StiffnessTensor<dim>> solver(in_orthonormal_basis<dim>(stiffness),
                                                                   Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff();
}

IsotropicMeans isotropic_means(const StiffnessTensor<3>& stiffness) {
  const StiffnessTensor<3> compliance = stiffness.inverse();
  const auto normal = [](const StiffnessTensor<3>& m) { return m(0, 0) + m(1, 1) + m(2, 2); };
  const auto mixed = [](const StiffnessTensor<3>& m) { return m(0, 1) + m(1, 2) + m(2, 0); };
  const auto shears = [](const StiffnessTensor<3>& m) { return m(3, 3) + m(4, 4) + m(5, 5); };
  return {.bulk_voigt = (normal(stiffness) + 2.0 * mixed(stiffness)) / 9.0,
          .bulk_reuss = 1.0 / (normal(compliance) + 2.0 * mixed(compliance)),
          .shear_voigt = (normal(stiffness) - mixed(stiffness) + 3.0 * shears(stiffness)) / 15.0,
          .shear_reuss = 15.0 / (4.0 * normal(compliance) - 4.0 * mixed(compliance) + 3.0 * shears(compliance))};
}

template <int dim>
Moduli softer_moduli(const StiffnessTensor<dim>& stiffness) {
  constexpr double rounding = 1e-9;
  if (!stiffness.allFinite() || (stiffness - stiffness.transpose()).norm() > rounding * stiffness.norm()) {
    throw InputError("crystals: expected a symmetric stiffness of finite components");
  }
  const double least = least_stiffness<dim>(stiffness);
  if (!(least > 0.0)) {
    throw InputError(
        fmt::format("crystals: expected a positive definite stiffness, its least eigenvalue is {} Pa", least));
  }
  return {.bulk = least / 3.0, .shear = least / 2.0};
}

template StiffnessTensor<2> isotropic_stiffness<2>(const Moduli&);
template StiffnessTensor<3> isotropic_stiffness<3>(const Moduli&);
template StiffnessTensor<2> in_orthonormal_basis<2>(StiffnessTensor<2>);
template StiffnessTensor<3> in_orthonormal_basis<3>(StiffnessTensor<3>);
template double least_stiffness<2>(const StiffnessTensor<2>&);
template double least_stiffness<3>(const StiffnessTensor<3>&);
template Moduli softer_moduli<2>(const StiffnessTensor<2>&);
template Moduli softer_moduli<3>(const StiffnessTensor<3>&);

}  // namespace breccia
