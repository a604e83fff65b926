#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace breccia::films {

/// The order in which the unknowns of a symmetric matrix, given by its lower triangle, are best eliminated: the place
/// of each unknown in the order, from 0. Nested dissection of the graph of the matrix by METIS (Karypis and Kumar
/// 1998), in which neighbouring unknowns with the same entries, as the components of a displacement, count as one
/// vertex. Throws NumericalError when METIS fails, for want of memory.
[[nodiscard]] std::vector<int> elimination_order(const Eigen::SparseMatrix<double>& lower_triangle);

}  // namespace breccia::films
