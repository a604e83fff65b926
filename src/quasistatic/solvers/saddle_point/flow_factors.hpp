#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/SparseCholesky>

#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// The inverse of the resistance H of the flows, and an approximate inverse of the Schur complement of the pressures,
///
///     S = 1/k + a/G + B_q diag(H)^-1 B_q',
///
/// with the volume changes B_q q by flows: in gaps it is the equation of lubrication, elsewhere the usual mass matrix
/// over a shear modulus (Elman, Silvester and Wathen 2014, section 3.5). Both by sparse factors.
class FlowFactors {
 public:
  /// Takes the present moduli of the operator.
  explicit FlowFactors(const SaddlePointOperator& saddle);

  /// Finds flows, and pressures, as entries of a field.
  void apply(const NodalField& right, NodalField& solution) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Entries = std::vector<Eigen::Triplet<double>>;

  void factorise_resistance(const SaddlePointOperator& saddle);
  void factorise_schur_complement(const SaddlePointOperator& saddle);
  [[nodiscard]] std::vector<double> compliance_of_pressures(const SaddlePointOperator& saddle) const;

  std::size_t first_gap_, first_pressure_, cells_;
  std::vector<std::size_t> flows_;  ///< entries of the flows
  std::vector<double> resistance_;  ///< the diagonal of H, by value of a gap
  Eigen::SimplicialLDLT<Matrix> of_flows_, of_pressures_;
};

}  // namespace breccia::quasistatic
