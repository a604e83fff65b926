#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// The sum over the cells around each node of a value of the kind of the cell.
template <class Value>
std::vector<double> sum_around_nodes(const NodeLattice& lattice, const CellModuli& cells, const Value& value_of_kind) {
  std::vector<double> sum(lattice.size(), 0.0);
  for_each_index(Index<3>{}, lattice.cells, [&](const Index<3>& cell) {
    const double value = value_of_kind(cells.kind_of.of(cell));
    for (int node = 0; node < Shape::nodes; ++node) sum[index_of_node(lattice, cell, node)] += value;
  });
  return sum;
}

}  // namespace

Index<3> node_of_cell(const NodeLattice& lattice, const Index<3>& cell, int node) noexcept {
  auto place = Shape::corner(node);
  for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = (place[axis] + cell[axis]) % lattice.nodes[axis];
  return place;
}

std::size_t index_of_node(const NodeLattice& lattice, const Index<3>& cell, int node) noexcept {
  return lattice.index_of(node_of_cell(lattice, cell, node));
}

Shape::Stiffness stiffness_of_cube(const Moduli& moduli) {
  Shape::PointModuli of_points;
  of_points.fill(moduli);
  return Shape::stiffness(of_points, Volumetric::averaged);
}

std::vector<double> shear_around_nodes(const NodeLattice& lattice, const CellModuli& cells) {
  return sum_around_nodes(lattice, cells, [&](std::size_t kind) { return cells.shear[kind] / Shape::nodes; });
}

std::vector<double> diagonal_of_nodes(const NodeLattice& lattice, const CellModuli& cells) {
  const double of_shear = stiffness_of_cube({.bulk = 0.0, .shear = 1.0})(0, 0);
  const double of_bulk = stiffness_of_cube({.bulk = 1.0, .shear = 0.0})(0, 0);
  return sum_around_nodes(lattice, cells,
                          [&](std::size_t kind) { return of_shear * cells.shear[kind] + of_bulk * cells.bulk[kind]; });
}

}  // namespace breccia::quasistatic
