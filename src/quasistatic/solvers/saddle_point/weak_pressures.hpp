#pragma once

#include <Eigen/SparseCholesky>

#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// The pressures that the nodes of a periodic box hardly resist, as a coarse space Z for the Schur complement S of the
/// pressures: those that change their sign from cell to cell along all three axes, with an amplitude that varies slowly
/// (Boland and Nicolaides 1985); and the uniform pressure, which nothing resists but the bulk modulus. An approximate
/// inverse of S takes them as any others, and an iteration finds them last.
class WeakPressures {
 public:
  /// Takes the present moduli of the operator.
  explicit WeakPressures(const SaddlePointOperator& saddle);

  /// Adds Z (Z' S Z)^-1 Z' of the volume changes `right` to the pressures of a field.
  void add_to(const NodalField& right, NodalField& solution) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  void find_amplitudes(const SaddlePointOperator& saddle);

  std::size_t first_pressure_;
  Matrix alternating_;  ///< pressures of the cells that alternate, by amplitude
  Eigen::SimplicialLDLT<Matrix> of_amplitudes_;
  double compliance_of_uniform_ = 0.0;
};

}  // namespace breccia::quasistatic
