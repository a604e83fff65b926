#pragma once

#include <Eigen/Core>

namespace breccia {

/// x >= 0 that makes |A x - b| least: the active-set method of Lawson and Hanson (Solving Least Squares Problems, 1974,
/// chapter 23), with orthogonal factors. Columns of any scale.
/// Throws NumericalError when it does not end, which data that are not finite can cause.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace breccia
