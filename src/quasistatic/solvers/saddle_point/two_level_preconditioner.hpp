#pragma once

#include <vector>

#include "quasistatic/solvers/direct/cholesky_factors.hpp"
#include "quasistatic/solvers/saddle_point/rigid_aggregates.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// An approximate inverse of SaddlePointOperator::multiply_similar(): a symmetric cycle of two levels, with Chebyshev
/// polynomials of the scaled operator as smoothers (Adams, Brezina, Hu and Tuminaro 2003) and the rigid motions of
/// small aggregates as the coarse space. Its condition number hardly depends on the contrast of the moduli.
class TwoLevelPreconditioner {
 public:
  /// Takes the present moduli of the operator, which must outlive this object.
  explicit TwoLevelPreconditioner(SaddlePointOperator& saddle);

  /// Finds the displacements of nodes from the forces on nodes; sets all further values to zero.
  void apply(const NodalField& forces, NodalField& displacement);

 private:
  void find_scale();
  /// Reduces the error of a displacement by a polynomial; `residual` is that of the displacement, and out of date
  /// afterwards.
  void smooth(NodalField& residual, NodalField& displacement);
  /// residual = forces - A displacement
  void find_residual(const NodalField& forces, NodalField& displacement);

  SaddlePointOperator* saddle_;
  RigidAggregates aggregates_;
  double largest_;             ///< a bound of the eigenvalues of the scaled operator
  std::vector<double> scale_;  ///< inverse of the diagonal by entry of one component; zero for entries without a node
  CholeskyFactors coarse_;
  std::vector<double> coarse_forces_, coarse_motions_;
  NodalField residual_, step_, work_;
};

}  // namespace breccia::quasistatic
