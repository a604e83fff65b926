#pragma once

#include <string>
#include <vector>

#include <Eigen/Dense>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/cell.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// A solution for one pair of matrix moduli that went into a reduced response.
struct Snapshot {
  Moduli matrix = {};  ///< [Pa]
  /// Relative error of the modulus there just before it was added, for those that were added where the error was
  /// expected to be largest; of the first ones, 0 [-].
  double error_before = 0.0;
};

/// The stiffness of one microstructure with elastic filler under one load and boundary, as a function of the matrix's
/// moduli G and K: a Galerkin projection of K(G, K) = A + G B + K C on a few solutions (theory, Eq. 18). From above for
/// displacement and periodic boundaries, from below for a traction one (the compliance).
struct ReducedResponse {
  Load load = Load::shear;
  Boundary boundary = Boundary::displacement;
  Eigen::MatrixXd filler;        ///< A, r x r
  Eigen::MatrixXd matrix_shear;  ///< B, r x r
  Eigen::MatrixXd matrix_bulk;   ///< C, r x r
  Eigen::VectorXd load_forces;   ///< e, r; the compliance is e' K^-1 e
  /// Scalar products of the residual's parts A v, B v, C v (of r vectors each) and the load.
  Eigen::MatrixXd residual_products;
  double residual_scale = 0.0;  ///< largest ratio of a measured error to what the residual tells
  std::vector<Snapshot> snapshots;

  /// Modulus of the composite [Pa] with an elastic matrix.
  [[nodiscard]] double modulus(const Moduli& matrix) const;
  /// Estimate of its relative error, from the residual [-].
  [[nodiscard]] double error_estimate(const Moduli& matrix) const;
};

/// Leaves a response in a group of a state, and takes it up. The latter throws FileError where that is none.
void save(StateWriter& state, const std::string& group, const ReducedResponse& response);
ReducedResponse read_response(const StateReader& state, const std::string& group);

/// Creep compliance [1/Pa] of the composite with a viscoelastic matrix: exact for the reduced stiffness (theory, Eqs.
/// 19 and 20). The relaxation modulus follows from it by interconversion.
CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix);

}  // namespace breccia
