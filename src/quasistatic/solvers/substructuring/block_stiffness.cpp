#include "quasistatic/solvers/substructuring/block_stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace breccia::quasistatic {
namespace {

/// A number of an unknown inside a block, 0, 1, ..., or of one of its boundary, -1, -2, ...
class UnknownNumbers {
 public:
  explicit UnknownNumbers(const BlockKind& kind)
      : width_(kind.shape.columns + 1),
        of_nodes_(static_cast<std::size_t>(width_) * (static_cast<std::size_t>(kind.shape.rows) + 1)) {
    int number = 0;
    for (const auto& unknown : inside_unknowns(kind.shape, kind.faces)) set(unknown, number++);
    inside_ = number;
    number = 0;
    for (const auto& unknown : boundary_unknowns(kind.shape, kind.faces)) set(unknown, --number);
  }

  [[nodiscard]] int inside() const noexcept { return inside_; }
  /// Sets the numbers of the unknowns of the nodes of a cell, in the order of CellShape.
  void of_cell(int x, int y, std::span<int, CellShape<2>::dofs> numbers) const {
    for (int node = 0; node < CellShape<2>::nodes; ++node) {
      std::ranges::copy(of_nodes_[place_of(x + node % 2, y + node / 2)], numbers.begin() + 2 * node);
    }
  }
  [[nodiscard]] int of_face(std::int32_t number) const { return of_faces_.at(number); }

 private:
  void set(const BlockUnknown& unknown, int number) {
    if (unknown.of_face != BlockUnknown::none) {
      of_faces_[unknown.of_face] = number;
    } else {
      of_nodes_[place_of(unknown.x, unknown.y)][static_cast<std::size_t>(unknown.component)] = number;
    }
  }
  [[nodiscard]] std::size_t place_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_, inside_ = 0;
  std::vector<std::array<int, 2>> of_nodes_;
  std::unordered_map<std::int32_t, int> of_faces_;
};

/// The unknowns of a cell of a block, and its stiffness for them.
struct CellOfBlock {
  std::array<int, gaps::unknowns_of_cell<2>> unknowns = {};
  int count = CellShape<2>::dofs;
  const double* stiffness = nullptr;
};

/// Adds the unknowns of the faces of a cell. Returns the stiffness for all its unknowns.
Eigen::MatrixXd add_faces(const BlockKind::WithGaps& with_gaps, const UnknownNumbers& numbers, CellOfBlock& cell) {
  std::vector<Eigen::Index> rows(CellShape<2>::dofs);
  std::iota(rows.begin(), rows.end(), 0);
  for (std::size_t k = 0; k < with_gaps.cell->gap_unknowns.size(); ++k) {
    const auto number = with_gaps.cell->gap_unknowns[k];
    if (number == gaps::GapCell<2>::none) continue;
    rows.push_back(CellShape<2>::dofs + static_cast<Eigen::Index>(k));
    cell.unknowns.at(static_cast<std::size_t>(cell.count++)) = numbers.of_face(number);
  }
  return with_gaps.stiffness(rows, rows);
}

/// The largest difference of numbers of unknowns inside the block in one cell.
Eigen::Index half_bandwidth(const std::vector<CellOfBlock>& cells) {
  int band = 0;
  for (const auto& cell : cells) {
    int least = std::numeric_limits<int>::max(), most = -1;
    for (const int unknown : std::span(cell.unknowns).first(static_cast<std::size_t>(cell.count))) {
      if (unknown < 0) continue;
      least = std::min(least, unknown);
      most = std::max(most, unknown);
    }
    if (most >= 0) band = std::max(band, most - least);
  }
  return band;
}

}  // namespace

BlockStiffness::BlockStiffness(const BlockKind& kind, double stiffness_of_held) {
  const UnknownNumbers numbers(kind);
  std::vector<CellOfBlock> cells(kind.cells.size());
  std::vector<Eigen::MatrixXd> with_faces;
  with_faces.reserve(kind.with_gaps.size());
  for (int cell = 0; cell < static_cast<int>(kind.cells.size()); ++cell) {
    auto& of_block = cells[static_cast<std::size_t>(cell)];
    numbers.of_cell(cell % kind.shape.columns, cell / kind.shape.columns,
                    std::span(of_block.unknowns).first<CellShape<2>::dofs>());
    const auto* stiffness = kind.cells[static_cast<std::size_t>(cell)];
    if (stiffness == nullptr) with_faces.push_back(add_faces(kind.with_gaps[with_faces.size()], numbers, of_block));
    of_block.stiffness = stiffness != nullptr ? stiffness->data() : with_faces.back().data();
  }
  band_ = std::max<Eigen::Index>(2 * kind.shape.columns + 1, half_bandwidth(cells));
  factor_ = RowMajor::Zero(numbers.inside(), band_ + 1);
  const auto on_boundary = static_cast<Eigen::Index>(kind.held.size());
  inside_boundary_.setZero(inside(), on_boundary);
  boundary_.setZero(on_boundary, on_boundary);
  for (const auto& cell : cells) {
    add_cell(kind.held, std::span(cell.unknowns).first(static_cast<std::size_t>(cell.count)),
             Eigen::Map<const Eigen::MatrixXd>(cell.stiffness, cell.count, cell.count));
  }
  for (Eigen::Index i = 0; i < on_boundary; ++i) {
    if (kind.held[static_cast<std::size_t>(i)]) boundary_(i, i) = stiffness_of_held;
  }
  factorise();
}

/// Adds the stiffness of a cell to A_ii (in the place of its factor), A_ib and A_bb. Its unknowns have the numbers of
/// UnknownNumbers.
void BlockStiffness::add_cell(const std::vector<bool>& held, std::span<const int> unknowns,
                              const Eigen::Ref<const Eigen::MatrixXd>& stiffness) {
  const auto is_held = [&](int unknown) { return unknown < 0 && held[static_cast<std::size_t>(-unknown - 1)]; };
  for (std::size_t a = 0; a < unknowns.size(); ++a) {
    const int one = unknowns[a];
    if (is_held(one)) continue;
    for (std::size_t b = 0; b < unknowns.size(); ++b) {
      const int other = unknowns[b];
      if (is_held(other)) continue;
      const double value = stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      if (one >= 0 && other >= 0) {
        if (other <= one) factor_(one, other - one + band_) += value;
      } else if (one >= 0) {
        inside_boundary_(one, -other - 1) += value;
      } else if (other < 0) {
        boundary_(-one - 1, -other - 1) += value;
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
