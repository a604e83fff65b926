#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/discretisation/cell.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"

#include "operator/displacement.hpp"

namespace breccia::quasistatic {

/// The elastic operator K of a discretisation under one boundary condition: forces of displacements, K u, cell by cell
/// and without an assembled matrix. The nodes are distributed over the processes.
///
/// Lengths are in units of the cell side, which makes the stiffness of a cell independent of its size (theory, Eq. 5).
/// A displacement is u = a E x + w. A displacement boundary (KUBC) holds w at zero on the boundary of the box; under a
/// periodic one w is periodic, and held at zero on one node; under a traction boundary (SUBC) three components of w are
/// held at zero against rigid motions, and a is not used.
class ElasticOperator {
 public:
  ElasticOperator(const Discretisation& discretisation, Volumetric volumetric, Boundary boundary);

  [[nodiscard]] Boundary boundary() const noexcept { return boundary_; }
  /// Area of the box, in squares of the cell side.
  [[nodiscard]] double area() const noexcept { return static_cast<double>(columns_) * static_cast<double>(rows_); }
  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  /// Number of nodal components, the held ones included.
  [[nodiscard]] std::int64_t unknowns() const noexcept;

  /// A displacement, or forces, all zero.
  [[nodiscard]] Displacement zero() const;
  /// The displacement with the uniform strain of a load.
  [[nodiscard]] Displacement uniform_strain(Load load) const;
  /// Forces of a load: the force 1 on the macroscopic part under a displacement or periodic boundary; the nodal forces
  /// of the uniform traction of the stress 2 E under a traction boundary, with E the unit strain of the load.
  [[nodiscard]] Forces load_forces(Load load) const;
  /// K u, with the moduli [Pa] by material; zero on the held components of w.
  [[nodiscard]] Forces forces(std::span<const Moduli> moduli, Load load, const Displacement& displacement) const;

  /// Fluctuation w of all nodes of the box, x and y in turn, row by row from the lower left corner. A periodic box has
  /// no last row and column, which are the first ones again. On the first process; empty on the others.
  [[nodiscard]] std::vector<double> gathered(const Displacement& displacement) const;

  /// Is this component of w held at zero at a node?
  [[nodiscard]] bool is_held(int column, int row, int component) const noexcept;
  /// Number of the kind of a cell: cells of one kind have the same materials at the same points.
  [[nodiscard]] std::uint32_t kind_of_cell(int column, int row) const noexcept {
    return kind_of_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(column)];
  }
  /// Stiffness matrices of the kinds of cells, for moduli [Pa] by material.
  [[nodiscard]] std::vector<CellMatrix> stiffnesses(std::span<const Moduli> moduli) const;

  /// A sparse matrix with the pattern of K on w, without values.
  [[nodiscard]] Matrix make_matrix() const;
  /// Assembles K into such a matrix. Held components of w are coupled to nothing and get a diagonal entry.
  void assemble(std::span<const Moduli> moduli, Mat matrix) const;
  /// Attaches the rigid motions to a matrix as its near null space, for algebraic multigrid.
  void attach_rigid_motions(Mat matrix) const;

 private:
  /// Cells whose lower left node belongs to this process.
  struct CellRange {
    int first_column, last_column, first_row, last_row;
  };
  /// The nodes that this process sees: its own and their neighbours.
  struct Patch {
    int first_column, first_row, columns;
  };

  [[nodiscard]] std::array<int, 4> nodes_of_cell(int column, int row) const noexcept;
  template <class CellForces>
  [[nodiscard]] Forces sum_over_cells(const CellForces& cell_forces) const;
  void clear_held(Vec nodal) const;
  [[nodiscard]] CellVector held_mask(int column, int row) const noexcept;

  int columns_, rows_;
  Volumetric volumetric_;
  Boundary boundary_;
  std::vector<CellMaterials> kinds_;    ///< materials of the points of a cell, by kind of cell
  std::vector<std::uint32_t> kind_of_;  ///< by cell
  NodeGrid grid_;
  CellRange cells_{};
  Patch patch_{};
};

/// Displacements of the nodes of a cell, in units of its side, under a strain.
[[nodiscard]] CellVector affine_motion(const PlaneStrain& strain);

}  // namespace breccia::quasistatic
