#include "quasistatic/solvers/substructuring/edge_averages.hpp"

#include <vector>

namespace breccia::quasistatic {
namespace {

/// Stiffness S of the edge with all other unknowns of the block held.
Eigen::MatrixXd held_around(const BlockAtEdge& block) {
  const auto [begin, size] = side_range(block.shape, block.side);
  return block.condensed->block(begin, begin, size, size);
}

/// Stiffness of the edge and the two vertices at its ends, in this order, with all other unknowns of the block free: a
/// Schur complement.
Eigen::MatrixXd free_around(const BlockAtEdge& block) {
  const auto [begin, size] = side_range(block.shape, block.side);
  const Eigen::Index all = block.condensed->rows(), first_vertex = all - 8;
  std::vector<Eigen::Index> kept, others;
  for (Eigen::Index i = begin; i < begin + size; ++i) kept.push_back(i);
  for (const int end : ends_of(block.side)) {
    for (int component = 0; component < 2; ++component) kept.push_back(first_vertex + 2 * end + component);
  }
  std::vector<bool> is_kept(static_cast<std::size_t>(all), false);
  for (const auto i : kept) is_kept[static_cast<std::size_t>(i)] = true;
  for (Eigen::Index i = 0; i < all; ++i) {
    if (!is_kept[static_cast<std::size_t>(i)]) others.push_back(i);
  }
  const Eigen::MatrixXd coupling = (*block.condensed)(others, kept);
  const Eigen::MatrixXd inner = (*block.condensed)(others, others);
  return (*block.condensed)(kept, kept) - coupling.transpose() * inner.llt().solve(coupling);
}

}  // namespace

EdgeStiffness stiffness_at_edge(const BlockAtEdge& block) {
  const bool has_only_vertices = side_range(block.shape, block.side).size == 0;  // the block is one cell wide
  if (has_only_vertices) return {};
  return {held_around(block), free_around(block)};
}

EdgeAverage average_at_edge(const EdgeStiffness& lower, const EdgeStiffness& upper, double tolerance) {
  const auto& [s1, free1] = lower;
  const auto& [s2, free2] = upper;
  const Eigen::Index size = s1.rows();
  if (size == 0) return {};
  const Eigen::LLT<Eigen::MatrixXd> sum(s1 + s2);
  const Eigen::MatrixXd weight = sum.solve(s1);
  // The energy of a jump after averaging is the parallel sum s1 : s2 = s1 (s1 + s2)^-1 s2.
  Eigen::MatrixXd averaged = s2 * weight;
  averaged = 0.5 * (averaged + averaged.transpose()).eval();

  // The least energy of two blocks with that jump, and without a jump at the ends of the edge. The two blocks together
  // may float: a rigid motion of both takes no force, and a little additional stiffness does no harm.
  constexpr double little = 1e-12;
  Eigen::MatrixXd both = free1 + free2;
  both.diagonal().array() += little * both.trace();
  Eigen::MatrixXd least = free1.topRows(size) * both.llt().solve(free2.leftCols(size));
  least = 0.5 * (least + least.transpose()).eval();

  // The eigenproblem is: least v = m averaged v, with m between 0 and 1.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(least, averaged);
  Eigen::Index count = 0;
  while (count < size && modes.eigenvalues()[count] * tolerance < 1.0) ++count;
  return {weight, averaged * modes.eigenvectors().leftCols(count)};
}

}  // namespace breccia::quasistatic
