#include "breccia/viscoelasticity/elastic_constants.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace breccia {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 matrix_of(const ElasticConstants& constants) {
  Matrix6 matrix;
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      matrix(i, j) = constants[place_of_constant(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(j) + 1)];
    }
  }
  return matrix;
}

}  // namespace

double least_stiffness(const ElasticConstants& constants) {
  auto orthonormal = matrix_of(constants);
  // Engineering shears are root 2 times the coordinates in an orthonormal basis.
  orthonormal.bottomRows<3>() *= std::sqrt(2.0);
  orthonormal.rightCols<3>() *= std::sqrt(2.0);
  return Eigen::SelfAdjointEigenSolver<Matrix6>(orthonormal, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

IsotropicMeans isotropic_means(const ElasticConstants& constants) {
  const Matrix6 c = matrix_of(constants), s = c.inverse();
  const auto normal = [](const Matrix6& m) { return m(0, 0) + m(1, 1) + m(2, 2); };
  const auto mixed = [](const Matrix6& m) { return m(0, 1) + m(1, 2) + m(2, 0); };
  const auto shears = [](const Matrix6& m) { return m(3, 3) + m(4, 4) + m(5, 5); };
  return {.bulk_voigt = (normal(c) + 2.0 * mixed(c)) / 9.0,
          .bulk_reuss = 1.0 / (normal(s) + 2.0 * mixed(s)),
          .shear_voigt = (normal(c) - mixed(c) + 3.0 * shears(c)) / 15.0,
          .shear_reuss = 15.0 / (4.0 * normal(s) - 4.0 * mixed(s) + 3.0 * shears(s))};
}

}  // namespace breccia
