#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// Small sets of nodes of a periodic box that move nearly as rigid bodies: the nodes in a cube of nodes that are joined
/// by cells as stiff as the mean around these nodes. The rigid motions of all sets span a coarse space by plain
/// aggregation (Vanek, Mandel and Brezina 1996). A cell that is softer must not join nodes: what hangs on it would
/// swing like a door, with little energy.
class RigidAggregates {
 public:
  /// The rigid motions of a node, for the unknowns of its aggregate.
  using Motions = Eigen::Matrix<double, 3, 6>;

  /// `side` is the number of nodes along the edge of a cube, `cells` are the moduli of the cells.
  RigidAggregates(const NodeLattice& lattice, const CellModuli& cells, int side);

  /// Number of the unknowns: the motions of the aggregates, up to six each.
  [[nodiscard]] int unknowns() const noexcept { return unknowns_; }
  /// Index of the first unknown of a node, and their number.
  [[nodiscard]] int first_unknown(std::size_t node) const noexcept { return of(node).first; }
  [[nodiscard]] int motions_of(std::size_t node) const noexcept { return of(node).motions; }
  /// The motions of a node; columns behind motions_of() are zero.
  [[nodiscard]] Motions motions(const Index<3>& node) const noexcept;

  /// The forces on the unknowns of nodal forces.
  void restrict_to(std::vector<double>& unknowns, const NodalField& forces) const;
  /// Adds the displacements of the unknowns.
  void prolong(const std::vector<double>& unknowns, NodalField& displacement) const;

 private:
  struct Aggregate {
    Eigen::Vector3d centre;
    Eigen::Matrix<double, 6, 6> motions_by_unknown;  ///< rigid motions about the centre, orthonormal over the nodes
    int first = 0, motions = 0;
  };

  [[nodiscard]] const Aggregate& of(std::size_t node) const noexcept {
    return aggregates_[static_cast<std::size_t>(of_node_[node])];
  }
  void join(const CellModuli& cells, int side);
  void find_motions();
  template <class Work>
  void for_nodes(const Work& work) const;

  NodeLattice lattice_;
  std::vector<std::int32_t> of_node_;  ///< aggregate by node
  std::vector<Aggregate> aggregates_;
  int unknowns_ = 0;
};

}  // namespace breccia::quasistatic
