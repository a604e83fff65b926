#pragma once

#include <Eigen/Core>

namespace breccia {

/// The x >= 0 that minimises |A x - b|, by the active-set method of Lawson and Hanson (Solving Least Squares Problems,
/// 1974, chapter 23), with orthogonal factors. The columns of A may have any scale.
/// Throws NumericalError when the method does not converge, for example because data are not finite.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace breccia
