#include "quasistatic/solvers/saddle_point/coarse_stiffness.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// The motions of the nodes of a cell, and the unknowns of their aggregates.
struct MotionsOfCell {
  std::array<RigidAggregates::Motions, Shape::nodes> motions;
  std::array<int, Shape::nodes> first_unknown = {}, unknowns = {};

  MotionsOfCell(const NodeLattice& lattice, const RigidAggregates& aggregates, const Index<3>& cell) {
    for (std::size_t n = 0; n < motions.size(); ++n) {
      const auto node = node_of_cell(lattice, cell, static_cast<int>(n));
      const auto index = lattice.index_of(node);
      motions[n] = aggregates.motions(node);
      first_unknown[n] = aggregates.first_unknown(index);
      unknowns[n] = aggregates.motions_of(index);
    }
  }

  [[nodiscard]] bool are_of_one_aggregate() const noexcept {
    return std::ranges::all_of(first_unknown, [&](int first) { return first == first_unknown.front(); });
  }
};

/// The stiffness between the unknowns of two aggregates.
struct Coupling {
  int rows, columns;
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
};

/// By the first unknowns of both aggregates, in ascending order.
using Couplings = std::map<std::pair<int, int>, Coupling>;

void add_cell(const MotionsOfCell& cell, const Shape::Stiffness& stiffness, Couplings& couplings) {
  for (std::size_t a = 0; a < Shape::nodes; ++a) {
    for (std::size_t b = 0; b < Shape::nodes; ++b) {
      if (cell.first_unknown[a] > cell.first_unknown[b]) continue;
      const std::pair place = {cell.first_unknown[a], cell.first_unknown[b]};
      auto& coupling = couplings.try_emplace(place, Coupling{cell.unknowns[a], cell.unknowns[b]}).first->second;
      coupling.stiffness += cell.motions[a].transpose() *
                            stiffness.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b)) *
                            cell.motions[b];
    }
  }
}

/// The couplings by cells whose nodes are in different aggregates; the other cells do not resist rigid motions.
Couplings couplings_of(const NodeLattice& lattice, const CellModuli& cells, const RigidAggregates& aggregates) {
  const auto shear = stiffness_of_cube({.bulk = 0.0, .shear = 1.0}),
             bulk = stiffness_of_cube({.bulk = 1.0, .shear = 0.0});
  Couplings couplings;
  for_each_index(Index<3>{}, lattice.cells, [&](const Index<3>& cell) {
    const MotionsOfCell motions(lattice, aggregates, cell);
    if (motions.are_of_one_aggregate()) return;
    const auto kind = cells.kind_of.of(cell);
    add_cell(motions, cells.shear[kind] * shear + cells.bulk[kind] * bulk, couplings);
  });
  return couplings;
}

MatrixEntries upper_triangle(const Couplings& couplings) {
  MatrixEntries entries;
  for (const auto& [place, coupling] : couplings) {
    const auto [first_row, first_column] = place;
    for (int row = 0; row < coupling.rows; ++row) {
      for (int column = first_row == first_column ? row : 0; column < coupling.columns; ++column) {
        entries.add(first_row + row, first_column + column, coupling.stiffness(row, column));
      }
    }
  }
  return entries;
}

/// Lets a little of its own stiffness hold the first aggregate, and so the translations of the box, which have no
/// forces.
void hold_first_aggregate(const Coupling& own, MatrixEntries& entries) {
  constexpr double little = 1e-6;
  for (int unknown = 0; unknown < own.rows; ++unknown) {
    entries.add(unknown, unknown, little * own.stiffness(unknown, unknown));
  }
}

}  // namespace

MatrixEntries coarse_stiffness(const NodeLattice& lattice, const CellModuli& cells, const RigidAggregates& aggregates) {
  const auto couplings = couplings_of(lattice, cells, aggregates);
  auto entries = upper_triangle(couplings);
  hold_first_aggregate(couplings.at({0, 0}), entries);
  return entries;
}

}  // namespace breccia::quasistatic
