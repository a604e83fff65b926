#pragma once

#include <random>
#include <vector>

#include <Eigen/Dense>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/solvers/substructuring/block_stiffness.hpp"

namespace breccia::test {

using quasistatic::Block;
using quasistatic::BlockKind;
using quasistatic::boundary_nodes;

/// Cells of random materials: each point has one of two elastic solids whose shear moduli differ by a contrast. The
/// softer one is nearly incompressible for a high contrast.
inline std::vector<CellShape<2>::Stiffness> random_cells(int count, double contrast, std::uint64_t seed) {
  const Moduli hard = {.bulk = 13.4, .shear = 5.84}, soft = {.bulk = 3.6, .shear = 5.84 / contrast};
  std::mt19937_64 random(seed);
  std::vector<CellShape<2>::Stiffness> cells;
  for (int cell = 0; cell < count; ++cell) {
    CellShape<2>::PointModuli moduli{};
    for (auto& point : moduli) point = random() % 2 == 0 ? hard : soft;
    cells.push_back(CellShape<2>::stiffness(moduli, Volumetric::averaged));
  }
  return cells;
}

/// A block of these cells with no displacement held.
inline BlockKind block_of(const Block& shape, const std::vector<CellShape<2>::Stiffness>& cells) {
  BlockKind kind = {shape, {}, std::vector<bool>(2 * boundary_nodes(shape).size(), false)};
  for (const auto& cell : cells) kind.cells.push_back(&cell);
  return kind;
}

/// The stiffness of a block as a dense matrix: the unknowns inside, row by row, and then those of the boundary in the
/// order of boundary_nodes.
inline Eigen::MatrixXd dense_stiffness(const Block& shape, const std::vector<CellShape<2>::Stiffness>& cells) {
  Eigen::MatrixX<Eigen::Index> number(shape.columns + 1, shape.rows + 1);
  const auto at = [&](int x, int y) -> Eigen::Index& { return number(x, y); };
  Eigen::Index count = 0;
  for (int y = 1; y < shape.rows; ++y) {
    for (int x = 1; x < shape.columns; ++x) at(x, y) = count++;
  }
  for (const auto& [x, y] : boundary_nodes(shape)) at(x, y) = count++;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) {
    const int x = cell % shape.columns, y = cell / shape.columns;
    for (int a = 0; a < CellShape<2>::dofs; ++a) {
      for (int b = 0; b < CellShape<2>::dofs; ++b) {
        const auto i = 2 * at(x + a / 2 % 2, y + a / 4) + a % 2, j = 2 * at(x + b / 2 % 2, y + b / 4) + b % 2;
        dense(i, j) += cells[static_cast<std::size_t>(cell)](a, b);
      }
    }
  }
  return dense;
}

}  // namespace breccia::test
