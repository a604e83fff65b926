#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace breccia::films {

/// An order of elimination with little fill-in for the unknowns of a symmetric matrix, given by its lower triangle: the
/// position of each unknown in the order, from 0. It is found by nested dissection of the graph of the matrix by METIS
/// (Karypis and Kumar 1998), in which neighbouring unknowns with the same entries, such as the components of a
/// displacement, count as one vertex. Throws NumericalError when METIS fails for lack of memory.
[[nodiscard]] std::vector<int> elimination_order(const Eigen::SparseMatrix<double>& lower_triangle);

}  // namespace breccia::films
