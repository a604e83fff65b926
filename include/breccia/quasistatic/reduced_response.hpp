#pragma once

#include <vector>

#include <Eigen/Dense>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// One solution of a reduced basis: the elastic composite for one pair of matrix moduli.
struct Snapshot {
  Moduli matrix = {};  ///< moduli of the matrix [Pa]
  /// Relative error of the reduced modulus at these moduli just before the snapshot was added [-]. It is measured for
  /// the snapshots of the greedy selection, and 0 for the initial ones.
  double error_before = 0.0;
};

/// The stiffness of one microstructure with elastic filler under one load and boundary condition, as a function of the
/// shear modulus G and bulk modulus K of the matrix: the Galerkin projection of K(G, K) = A + G B + K C on a reduced
/// basis of r vectors (theory, Eq. 18). The modulus of the projection is never below that of the unreduced composite,
/// under any boundary condition.
struct ReducedResponse {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Eigen::MatrixXd filler;        ///< A, r x r
  Eigen::MatrixXd matrix_shear;  ///< B, r x r
  Eigen::MatrixXd matrix_bulk;   ///< C, r x r
  Eigen::VectorXd load_forces;   ///< e, r; the compliance is e' K^-1 e
  /// Scalar products of the parts of the residual, A v, B v and C v of the r vectors v, and of the load: 3 r + 1
  /// square.
  Eigen::MatrixXd residual_products;
  double residual_scale = 0.0;  ///< largest ratio of a measured error to its estimate from the residual [-]
  std::vector<Snapshot> snapshots;

  /// Modulus of the composite [Pa] with an elastic matrix of these moduli [Pa].
  [[nodiscard]] double modulus(const Moduli& matrix) const;
  /// Estimate of the relative error of that modulus, from the residual of the reduced solution [-].
  [[nodiscard]] double error_estimate(const Moduli& matrix) const;
};

/// Creep compliance [1/Pa] of the composite with a viscoelastic matrix. It is exact for the reduced stiffness (theory,
/// Eqs. 19 and 20). The relaxation modulus follows from it by interconversion.
CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix);

}  // namespace breccia
