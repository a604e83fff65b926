#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/discretisation/cell.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"

#include "field.hpp"

namespace breccia::quasistatic {

/// The nodes of a discretisation under one boundary, spread over the processes, and the forces of its cells.
///
/// Lengths are in units of the cell side, in which stiffnesses do not depend on it (theory, Eq. 5). A displacement is
/// u = a E x + w. With a displacement boundary w is zero on it; with a periodic one w is periodic and zero on one node;
/// with a traction boundary three components of w that could be a rigid motion are zero, and a is not used.
class ElasticBox {
 public:
  ElasticBox(const Discretisation& discretisation, Volumetric volumetric, Boundary boundary);

  [[nodiscard]] Boundary boundary() const noexcept { return boundary_; }
  /// Of the box, in squares of the cell side.
  [[nodiscard]] double area() const noexcept { return static_cast<double>(columns_) * static_cast<double>(rows_); }
  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  [[nodiscard]] std::int64_t unknowns() const noexcept;

  [[nodiscard]] Field zero_field() const;
  /// The displacement with the uniform strain of a load.
  [[nodiscard]] Field uniform_strain(Load load) const;
  /// What the load does: 1 on the affine motion where that is given; the traction of the stress 2 unit_strain.
  [[nodiscard]] Field load_forces(Load load) const;
  /// K u, with the moduli by material; zero on the components of w that are held.
  [[nodiscard]] Field forces(std::span<const Moduli> moduli, Load load, const Field& displacement) const;

  /// w of all nodes of the box, x and y in turn, row by row from the lower left corner; of a periodic box without the
  /// last row and column, which are the first. On the first process; on the others empty.
  [[nodiscard]] std::vector<double> gathered(const Field& displacement) const;

  /// Whether the component of w at a node is zero.
  [[nodiscard]] bool is_held(int column, int row, int component) const noexcept;
  /// Cells of one kind have the same materials in the same places.
  [[nodiscard]] std::uint32_t kind_of_cell(int column, int row) const noexcept {
    return kind_of_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)];
  }
  /// By kind of cell.
  [[nodiscard]] std::vector<CellMatrix> stiffnesses(std::span<const Moduli> moduli) const;

  /// A matrix for K on w, without values.
  [[nodiscard]] Matrix make_matrix() const;
  /// Fills it; the components of w that are held get a stiffness of their own.
  void assemble(std::span<const Moduli> moduli, Mat matrix) const;
  /// The rigid motions, for algebraic multigrid.
  void attach_rigid_motions(Mat matrix) const;

 private:
  /// Cells whose lower left node is this process's.
  struct CellRange {
    int first_column, last_column, first_row, last_row;
  };
  struct Patch {
    int first_column, first_row, columns;  ///< of the nodes that this process sees
  };

  [[nodiscard]] std::array<int, 4> nodes_of_cell(int column, int row) const noexcept;
  template <class CellForces>
  [[nodiscard]] Field sum_over_cells(const CellForces& cell_forces) const;
  void clear_held(Vec nodal) const;
  [[nodiscard]] CellVector held_mask(int column, int row) const noexcept;

  int columns_, rows_;
  Volumetric volumetric_;
  Boundary boundary_;
  std::vector<CellMaterials> kinds_;    ///< the different cells that there are
  std::vector<std::uint32_t> kind_of_;  ///< by cell
  NodeGrid grid_;
  CellRange cells_{};
  Patch patch_{};
};

/// Displacements of the nodes of a cell, in units of its side, under a strain.
[[nodiscard]] CellVector affine_motion(const PlaneStrain& strain);

}  // namespace breccia::quasistatic
