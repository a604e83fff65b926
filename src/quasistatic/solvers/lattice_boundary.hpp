#pragma once

#include <petscvec.h>

#include "solvers/lattice_field.hpp"

namespace breccia::quasistatic {

/// What the boundary condition of a box asks of the fields of its lattice. NodeLayout holds single components of a
/// periodic or free box at zero, to suppress its rigid motions. On a lattice no component of such a box is held: forces
/// are completed by those that balance them, and the rigid motion is taken away at the end. Displacement boundaries
/// hold the nodes on the walls.
class LatticeBoundary {
 public:
  explicit LatticeBoundary(const NodeLattice& lattice) : lattice_(lattice) {}

  /// Nodal values, the components of one node after those of the other, as a field, and back.
  void read(Vec nodal, LatticeField& field) const;
  void write(const LatticeField& field, Vec nodal) const;

  /// Adds the forces on held components that balance all others.
  void balance(LatticeField& forces) const;
  /// Takes the rigid motion away that moves held components.
  void settle(LatticeField& displacement) const;

  /// Repeats the first nodes of the rows of a periodic box behind the last ones.
  void repeat_first_nodes(LatticeField& displacement) const;
  /// Adds the forces on those to the first nodes, and takes the forces on held walls away.
  void collect(LatticeField& forces) const;

 private:
  [[nodiscard]] std::size_t place_of(const Index<3>& node) const noexcept;
  /// The corner of the box at the end of an axis.
  [[nodiscard]] std::size_t corner(std::size_t axis) const noexcept;
  template <class Work>
  void for_rows(const Work& work) const;

  NodeLattice lattice_;
};

}  // namespace breccia::quasistatic
