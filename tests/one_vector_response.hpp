#pragma once

#include <utility>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::test {

/// A composite whose modulus is constant + in_shear G + in_bulk K, with the moduli G and K of its matrix.
struct LinearComposite {
  double constant = 0.0;  ///< [Pa]
  double in_shear = 1.0;  ///< [-]
  double in_bulk = 0.0;   ///< [-]
};

/// The reduced response of a LinearComposite: a basis of a single vector, which leaves no residual.
inline ReducedResponse one_vector_response(Load load, Boundary boundary, const LinearComposite& composite,
                                           std::vector<Snapshot> snapshots) {
  const auto number = [](double value) -> Eigen::MatrixXd { return Eigen::MatrixXd::Constant(1, 1, value); };
  ReducedResponse response;
  response.load = load;
  response.boundary = boundary;
  response.constant = number(composite.constant);
  response.parts = matrix_parts(number(composite.in_shear), number(composite.in_bulk));
  response.load_forces = Eigen::VectorXd::Ones(1);
  response.residual_products = Eigen::MatrixXd::Zero(4, 4);
  response.residual_scale = 1.0;
  response.snapshots = std::move(snapshots);
  return response;
}

}  // namespace breccia::test
