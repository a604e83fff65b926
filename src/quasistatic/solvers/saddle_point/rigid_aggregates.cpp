#include "quasistatic/solvers/saddle_point/rigid_aggregates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// The motions of a node under translations along and rotations about each axis, at a place relative to the centre.
RigidAggregates::Motions rigid_motions(const Eigen::Vector3d& place) {
  RigidAggregates::Motions motions;
  motions.leftCols<3>().setIdentity();
  for (int axis = 0; axis < 3; ++axis) motions.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(place);
  return motions;
}

/// The cube with a node of a cell, among cubes of `side` nodes or fewer along an edge. A node across the end of the
/// box, which is one of the first ones, is in a cube behind the last one.
Index<3> cube_at(const NodeLattice& lattice, const Index<3>& cell, int node, int side) {
  auto cube = Shape::corner(node);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int cubes = (lattice.nodes[axis] + side - 1) / side;
    cube[axis] = (cube[axis] + cell[axis]) * cubes / lattice.nodes[axis];
  }
  return cube;
}

/// Disjoint sets of numbers, which are joined one by one.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

  /// The smallest number of the set that has a number.
  [[nodiscard]] std::int32_t first_of(std::int32_t number) noexcept {
    while (parent(number) != number) number = parent(number) = parent(parent(number));
    return number;
  }
  void join(std::int32_t a, std::int32_t b) noexcept {
    a = first_of(a);
    b = first_of(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  [[nodiscard]] std::int32_t& parent(std::int32_t number) noexcept {
    return parents_[static_cast<std::size_t>(number)];
  }

  std::vector<std::int32_t> parents_;
};

}  // namespace

/// Calls work(node, its index) for all nodes.
template <class Work>
void RigidAggregates::for_nodes(const Work& work) const {
  for_each_index(Index<3>{}, lattice_.nodes, [&](const Index<3>& node) { work(node, lattice_.index_of(node)); });
}

RigidAggregates::RigidAggregates(const NodeLattice& lattice, const CellModuli& cells, int side)
    : lattice_(lattice), of_node_(lattice.size(), -1) {
  join(cells, side);
  find_motions();
}

/// Joins the nodes of a cell that is as stiff as the mean around them.
void RigidAggregates::join(const CellModuli& cells, int side) {
  constexpr double least = 0.99;  // the mean itself, up to rounding
  const auto around = shear_around_nodes(lattice_, cells);
  // The nodes of the first plane are joined by the cells above it, and not by those at the other end of the box.
  const auto is_in_first_plane_from_below = [&](const Index<3>& cell, std::size_t node) {
    return cell[2] + Shape::corner(static_cast<int>(node))[2] == lattice_.nodes[2];
  };
  DisjointSets sets(lattice_.size());
  for_each_index(Index<3>{}, lattice_.cells, [&](const Index<3>& cell) {
    std::array<Index<3>, Shape::nodes> cubes{};
    std::array<std::size_t, Shape::nodes> nodes{};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      cubes[n] = cube_at(lattice_, cell, static_cast<int>(n), side);
      nodes[n] = index_of_node(lattice_, cell, static_cast<int>(n));
    }
    const double shear = cells.shear[cells.kind_of.of(cell)];
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t b = a + 1; b < nodes.size(); ++b) {
        if (cubes[a] != cubes[b] || is_in_first_plane_from_below(cell, a)) continue;
        const double mean = std::sqrt(around[nodes[a]] * around[nodes[b]]);
        if (shear >= least * mean) sets.join(static_cast<std::int32_t>(nodes[a]), static_cast<std::int32_t>(nodes[b]));
      }
    }
  });
  std::int32_t count = 0;
  for_nodes([&](const Index<3>&, std::size_t index) {
    const auto first = static_cast<std::size_t>(sets.first_of(static_cast<std::int32_t>(index)));
    if (of_node_[first] < 0) of_node_[first] = count++;
    of_node_[index] = of_node_[first];
  });
  aggregates_.resize(static_cast<std::size_t>(count));
}

/// Rigid motions of few nodes, or of nodes on a line, are not independent: only those that are count.
void RigidAggregates::find_motions() {
  constexpr double rounding = 1e-10;
  std::vector<int> nodes(aggregates_.size(), 0);
  for (auto& aggregate : aggregates_) aggregate.centre.setZero();
  const auto place = [](const Index<3>& node) { return Eigen::Vector3d(node[0], node[1], node[2]); };
  const auto number = [&](std::size_t index) { return static_cast<std::size_t>(of_node_[index]); };
  for_nodes([&](const Index<3>& node, std::size_t index) {
    aggregates_[number(index)].centre += place(node);
    ++nodes[number(index)];
  });
  std::vector<Eigen::Matrix<double, 6, 6>> products(aggregates_.size(), Eigen::Matrix<double, 6, 6>::Zero());
  for (std::size_t a = 0; a < aggregates_.size(); ++a) aggregates_[a].centre /= nodes[a];
  for_nodes([&](const Index<3>& node, std::size_t index) {
    const auto motions = rigid_motions(place(node) - aggregates_[number(index)].centre);
    products[number(index)] += motions.transpose() * motions;
  });
  for (std::size_t a = 0; a < aggregates_.size(); ++a) {
    auto& [centre, by_unknown, first, motions] = aggregates_[a];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> modes(products[a]);
    by_unknown.setZero();
    first = unknowns_;
    motions = 0;
    for (Eigen::Index mode = 5; mode >= 0; --mode) {
      const double size = modes.eigenvalues()[mode];
      if (!(size > rounding * modes.eigenvalues()[5])) break;
      by_unknown.col(motions++) = modes.eigenvectors().col(mode) / std::sqrt(size);
    }
    unknowns_ += motions;
  }
}

RigidAggregates::Motions RigidAggregates::motions(const Index<3>& node) const noexcept {
  const auto& aggregate = of(lattice_.index_of(node));
  return rigid_motions(Eigen::Vector3d(node[0], node[1], node[2]) - aggregate.centre) * aggregate.motions_by_unknown;
}

void RigidAggregates::restrict_to(std::vector<double>& unknowns, const NodalField& forces) const {
  const auto components = forces.components();
  std::vector<Eigen::Matrix<double, 6, 1>> sums(aggregates_.size(), Eigen::Matrix<double, 6, 1>::Zero());
  for_nodes([&](const Index<3>& node, std::size_t index) {
    const auto number = static_cast<std::size_t>(of_node_[index]);
    const Eigen::Vector3d force(components[0][index], components[1][index], components[2][index]);
    const Eigen::Vector3d arm = Eigen::Vector3d(node[0], node[1], node[2]) - aggregates_[number].centre;
    sums[number].head<3>() += force;
    sums[number].tail<3>() += arm.cross(force);
  });
  for (std::size_t a = 0; a < aggregates_.size(); ++a) {
    const auto& [centre, by_unknown, first, motions] = aggregates_[a];
    Eigen::Map<Eigen::VectorXd>(unknowns.data() + first, motions) = by_unknown.leftCols(motions).transpose() * sums[a];
  }
}

void RigidAggregates::prolong(const std::vector<double>& unknowns, NodalField& displacement) const {
  const auto components = displacement.components();
  std::vector<Eigen::Matrix<double, 6, 1>> rigid(aggregates_.size());
  for (std::size_t a = 0; a < aggregates_.size(); ++a) {
    const auto& [centre, by_unknown, first, motions] = aggregates_[a];
    rigid[a] = by_unknown.leftCols(motions) * Eigen::Map<const Eigen::VectorXd>(unknowns.data() + first, motions);
  }
  for_nodes([&](const Index<3>& node, std::size_t index) {
    const auto number = static_cast<std::size_t>(of_node_[index]);
    const Eigen::Vector3d arm = Eigen::Vector3d(node[0], node[1], node[2]) - aggregates_[number].centre;
    const Eigen::Vector3d moved = rigid[number].head<3>() + rigid[number].tail<3>().cross(arm);
    for (std::size_t axis = 0; axis < 3; ++axis) components[axis][index] += moved[static_cast<Eigen::Index>(axis)];
  });
}

}  // namespace breccia::quasistatic
