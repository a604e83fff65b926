#include "quasistatic/solvers/substructuring/block_stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace breccia::quasistatic {
namespace {

/// Numbers of the nodes of a block, row by row: 0, 1, ... for the nodes inside it, -1, -2, ... for its boundary nodes.
std::vector<int> numbers_of_nodes(const Block& shape) {
  const auto width = static_cast<std::size_t>(shape.columns) + 1, height = static_cast<std::size_t>(shape.rows) + 1;
  std::vector<int> numbers(width * height, 0);
  const auto at = [&](int x, int y) -> int& {
    return numbers[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
  };
  int count = 0;
  for (int y = 1; y < shape.rows; ++y) {
    for (int x = 1; x < shape.columns; ++x) at(x, y) = count++;
  }
  int boundary = 0;
  for (const auto& [x, y] : boundary_nodes(shape)) at(x, y) = --boundary;
  return numbers;
}

}  // namespace

BlockStiffness::BlockStiffness(const BlockKind& kind, double stiffness_of_held)
    : band_(2 * kind.shape.columns + 1),
      factor_(RowMajor::Zero(2 * (kind.shape.columns - 1) * (kind.shape.rows - 1), band_ + 1)) {
  const auto on_boundary = static_cast<Eigen::Index>(kind.held.size());
  inside_boundary_.setZero(inside(), on_boundary);
  boundary_.setZero(on_boundary, on_boundary);
  const auto numbers = numbers_of_nodes(kind.shape);
  const int width = kind.shape.columns + 1;
  for (int cell = 0; cell < static_cast<int>(kind.cells.size()); ++cell) {
    const int x = cell % kind.shape.columns, y = cell / kind.shape.columns;
    std::array<int, 4> nodes{};
    for (int a = 0; a < 4; ++a) {
      const int node = (y + a / 2) * width + x + a % 2;
      nodes[static_cast<std::size_t>(a)] = numbers[static_cast<std::size_t>(node)];
    }
    add_cell(kind.held, nodes, *kind.cells[static_cast<std::size_t>(cell)]);
  }
  for (Eigen::Index i = 0; i < on_boundary; ++i) {
    if (kind.held[static_cast<std::size_t>(i)]) boundary_(i, i) = stiffness_of_held;
  }
  factorise();
}

/// Adds the stiffness of a cell to A_ii (in the place of its factor), A_ib and A_bb. Its nodes have the numbers of
/// numbers_of_nodes().
void BlockStiffness::add_cell(const std::vector<bool>& held, const std::array<int, 4>& nodes,
                              const CellShape<2>::Stiffness& stiffness) {
  const auto is_held = [&](int node, Eigen::Index unknown) {
    return node < 0 && held[static_cast<std::size_t>(unknown)];
  };
  for (int a = 0; a < CellShape<2>::dofs; ++a) {
    const int node = nodes[static_cast<std::size_t>(a / 2)];
    const Eigen::Index i = 2 * (node < 0 ? -node - 1 : node) + a % 2;
    if (is_held(node, i)) continue;
    for (int b = 0; b < CellShape<2>::dofs; ++b) {
      const int other = nodes[static_cast<std::size_t>(b / 2)];
      const Eigen::Index j = 2 * (other < 0 ? -other - 1 : other) + b % 2;
      if (is_held(other, j)) continue;
      if (node >= 0 && other >= 0) {
        if (j <= i) factor_(i, j - i + band_) += stiffness(a, b);
      } else if (node >= 0) {
        inside_boundary_(i, j) += stiffness(a, b);
      } else if (other < 0) {
        boundary_(i, j) += stiffness(a, b);
      }
    }
  }
}

void BlockStiffness::factorise() {
  for (Eigen::Index i = 0; i < inside(); ++i) {
    const Eigen::Index first = std::max<Eigen::Index>(0, i - band_);
    for (Eigen::Index j = first; j <= i; ++j) {
      // Columns first .. j - 1 of rows i and j.
      const Eigen::Index from = std::max(first, j - band_), count = j - from;
      const double sum =
          factor_.row(i).segment(from - i + band_, count).dot(factor_.row(j).segment(from - j + band_, count));
      auto& entry = factor_(i, j - i + band_);
      entry = j == i ? std::sqrt(entry - sum) : (entry - sum) / factor_(j, band_);
    }
  }
}

template <class Rows>
void BlockStiffness::solve_lower(Rows& right) const {
  for (Eigen::Index i = 0; i < inside(); ++i) {
    for (Eigen::Index j = std::max<Eigen::Index>(0, i - band_); j < i; ++j) {
      right.row(i) -= factor_(i, j - i + band_) * right.row(j);
    }
    right.row(i) /= factor_(i, band_);
  }
}

void BlockStiffness::solve_upper(Eigen::VectorXd& right) const {
  for (Eigen::Index i = inside() - 1; i >= 0; --i) {
    right[i] /= factor_(i, band_);
    for (Eigen::Index j = std::max<Eigen::Index>(0, i - band_); j < i; ++j) {
      right[j] -= factor_(i, j - i + band_) * right[i];
    }
  }
}

Eigen::MatrixXd BlockStiffness::condensed() const {
  RowMajor half = inside_boundary_;
  solve_lower(half);
  Eigen::MatrixXd condensed = boundary_;
  condensed.noalias() -= half.transpose() * half;
  return condensed;
}

Eigen::VectorXd BlockStiffness::carried_by_boundary(Eigen::VectorXd forces_inside) const {
  solve_lower(forces_inside);
  solve_upper(forces_inside);
  return inside_boundary_.transpose() * forces_inside;
}

Eigen::VectorXd BlockStiffness::displacement_inside(Eigen::VectorXd forces_inside,
                                                    const Eigen::VectorXd& boundary) const {
  forces_inside -= inside_boundary_ * boundary;
  solve_lower(forces_inside);
  solve_upper(forces_inside);
  return forces_inside;
}

}  // namespace breccia::quasistatic
