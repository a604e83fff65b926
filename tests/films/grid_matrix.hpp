#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace breccia::test {

using Sparse = Eigen::SparseMatrix<double>;

inline constexpr int side_of_grid = 40, components = 2;

/// Lower triangle of a quasi-definite matrix on a square grid of nodes of two components, each coupled to both of the
/// neighbours', and a negative unknown for every node (compare theory, Eq. 66).
inline Sparse grid_matrix(double stiffness) {
  constexpr int nodes = side_of_grid * side_of_grid;
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int a, int b) {
    for (int i = 0; i < components; ++i) {
      for (int j = 0; j < components; ++j) {
        entries.emplace_back(components * std::max(a, b) + i, components * std::min(a, b) + j,
                             i == j ? -stiffness : 0.1 * stiffness);
      }
    }
  };
  for (int node = 0; node < nodes; ++node) {
    if (node % side_of_grid > 0) couple(node, node - 1);
    if (node >= side_of_grid) couple(node, node - side_of_grid);
    for (int i = 0; i < components; ++i) {
      entries.emplace_back(components * node + i, components * node + i, 5.0 * stiffness);
      entries.emplace_back(components * nodes + node, components * node + i, 1.0 + i);
    }
    entries.emplace_back(components * node + 1, components * node, 0.2 * stiffness);
    entries.emplace_back(components * nodes + node, components * nodes + node, -1.0);
  }
  Sparse matrix(3 * nodes, 3 * nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// A right side for the matrix.
inline Eigen::VectorXd right_side(const Sparse& matrix) {
  return Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 2.0).array().sin();
}

}  // namespace breccia::test
