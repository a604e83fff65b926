#include "breccia/discretisation/crystals.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
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

template <int dim>
Moduli softer_moduli(const StiffnessTensor<dim>& stiffness) {
  constexpr double rounding = 1e-9;
  if (!stiffness.allFinite() || (stiffness - stiffness.transpose()).norm() > rounding * stiffness.norm()) {
    throw InputError("crystals: expected a symmetric stiffness of finite components");
  }
  // Engineering shears are root 2 times the coordinates in an orthonormal basis.
  auto orthonormal = stiffness;
  constexpr int shears = tensor_components<dim> - dim;
  orthonormal.template bottomRows<shears>() *= std::sqrt(2.0);
  orthonormal.template rightCols<shears>() *= std::sqrt(2.0);
  const Eigen::SelfAdjointEigenSolver<StiffnessTensor<dim>> solver(orthonormal, Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues().minCoeff();
  if (!(least > 0.0)) {
    throw InputError(
        fmt::format("crystals: expected a positive definite stiffness, its least eigenvalue is {} Pa", least));
  }
  return {.bulk = least / 3.0, .shear = least / 2.0};
}

template StiffnessTensor<2> isotropic_stiffness<2>(const Moduli&);
template StiffnessTensor<3> isotropic_stiffness<3>(const Moduli&);
template Moduli softer_moduli<2>(const StiffnessTensor<2>&);
template Moduli softer_moduli<3>(const StiffnessTensor<3>&);

}  // namespace breccia
