#pragma once

#include <petscvec.h>

#include "quasistatic/solvers/lattice/nodal_field.hpp"
#include "quasistatic/solvers/lattice/plane_exchange.hpp"

namespace breccia::quasistatic {

/// The boundary condition of a box, applied to the fields of its lattice. NodeLayout holds single components of a
/// periodic or free box at zero, to suppress its rigid motions. On a lattice no component of such a box is held: forces
/// are completed by balancing ones, and the rigid motion is subtracted at the end. Displacement boundaries hold the
/// nodes on the walls.
class LatticeBoundary {
 public:
  explicit LatticeBoundary(const NodeLattice& lattice) : lattice_(lattice), exchange_(lattice) {}

  /// Converts nodal values, node by node with their components, to a field, and back.
  void read(Vec nodal, NodalField& field) const;
  void write(const NodalField& field, Vec nodal) const;

  /// Adds the forces on held components that balance all other forces.
  void balance(NodalField& forces) const;
  /// Subtracts the rigid motion that moves held components.
  void settle(NodalField& displacement) const;

  /// Repeats the first nodes of the rows of a periodic box behind the last ones, and copies the lowest plane of the
  /// process above.
  void repeat_first_nodes(NodalField& displacement) const;
  /// Adds the forces on the repeated nodes to the first nodes, sends the forces on the plane above to its process, and
  /// sets the forces on held walls to zero.
  void collect(NodalField& forces);

 private:
  /// Whether this process has the lowest plane, with the held corners.
  [[nodiscard]] bool has_corners() const noexcept { return lattice_.first_plane == 0; }
  /// The corner of the box at the end of the first or second axis.
  [[nodiscard]] std::size_t corner(std::size_t axis) const noexcept;
  template <class Work>
  void for_rows(const Work& work) const;

  NodeLattice lattice_;
  PlaneExchange exchange_;
};

}  // namespace breccia::quasistatic
