#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"

#include "discretisation/cell_shape.hpp"
#include "discretisation/gaps/gap_cells.hpp"
#include "quasistatic/operator/cell_kinds.hpp"
#include "quasistatic/operator/displacement.hpp"
#include "quasistatic/operator/gap_layout.hpp"
#include "quasistatic/operator/mixed_cell.hpp"
#include "quasistatic/operator/natural_order.hpp"
#include "quasistatic/operator/node_layout.hpp"

namespace breccia::quasistatic {

/// The elastic operator K of a discretisation under one boundary condition. Its forces K u are found cell by cell and
/// without an assembled matrix: forces_under() in square_forces.hpp and cube_forces.hpp. The nodes are distributed over
/// the processes.
///
/// Lengths are in units of the cell side, which makes the stiffness of a cell independent of its size (theory, Eq. 5).
/// A displacement is u = a E x + w. A displacement boundary (KUBC) holds w at zero on the boundary of the box; under a
/// periodic boundary w is periodic, and held at zero on one node; under a traction boundary (SUBC) as many components
/// of w as there are rigid motions are held at zero on corners of the box, and a is not used.
template <int dim>
class ElasticOperator {
 public:
  using Shape = CellShape<dim>;
  using CellValues = typename Shape::Values;

  /// `threads` is the number of threads that find forces in 3 dimensions, 0 for as many cores of the process as gain
  /// from it; the forces do not depend on it. The materials, by PhaseIndex, decide the rules of mixed cells, whose
  /// phases are in series without them. Throws InputError when a point has no phase, for mixed cells with the
  /// volumetric strains of points, for mixed cells with crystals, and for gaps that find_gap_cells() refuses or in a
  /// box that is not that of the grid.
  ElasticOperator(const Discretisation<dim>& discretisation, Volumetric volumetric, Boundary boundary, int threads = 1,
                  const Crystals& crystals = {}, std::span<const Material> materials = {});

  [[nodiscard]] Boundary boundary() const noexcept { return nodes_.boundary(); }
  [[nodiscard]] int threads() const noexcept { return threads_; }
  /// The cells, with side 1.
  [[nodiscard]] const Grid<dim>& grid() const noexcept { return nodes_.grid(); }
  /// Area or volume of the box, in units of the cell side.
  [[nodiscard]] double volume() const noexcept { return grid().volume(); }
  /// Number of nodal components, the held ones included, and of the unknowns of gaps.
  [[nodiscard]] std::int64_t unknowns() const noexcept { return nodes_.unknowns() + gap_unknowns(); }
  [[nodiscard]] bool has_gaps() const noexcept { return gap_unknowns() > 0; }

  /// A zero displacement, or zero forces.
  [[nodiscard]] Displacement zero() const { return {0.0, nodes_.zeros(), zero_strains_of_phases()}; }
  /// Zero strains of the phases of the mixed cells of each process, cell by cell.
  [[nodiscard]] NodalVector zero_strains_of_phases() const;
  /// The displacement with the uniform strain of a load, in all phases.
  [[nodiscard]] Displacement uniform_strain(Load load) const;
  /// Forces of a load: the force 1 on the macroscopic part under a displacement or periodic boundary; the nodal forces
  /// of the uniform traction of the unit stress of the load under a traction boundary.
  [[nodiscard]] Forces load_forces(Load load) const;
  /// Static condensation: changes the nodal forces to those that remain after the elimination of the strains of phases
  /// at these moduli [Pa], which are positive.
  void condense(std::span<const Moduli> moduli, Forces& forces) const;
  /// Sets the strains of phases to those in equilibrium with forces, from the fluctuation w of a displacement.
  void recover_phase_strains(std::span<const Moduli> moduli, const Forces& forces, Displacement& displacement) const;

  /// Whether this component of w is held at zero at a node.
  [[nodiscard]] bool is_held(const Index<dim>& node, int component) const noexcept {
    return nodes_.is_held(node, component);
  }
  /// Number of planes of cells of this process along the last axis.
  [[nodiscard]] int planes() const noexcept { return static_cast<int>(first_strain_.size()) - 1; }
  /// Calls action(cell, mixed cell, index of its first unknown strain) for the mixed cells of some of these planes.
  template <class Action>
  void for_mixed_cells_of_planes(int first_plane, int end_plane, Action&& action) const;
  [[nodiscard]] const CellKinds<dim>& kinds() const noexcept { return kinds_; }
  [[nodiscard]] const NodeLayout<dim>& nodes() const noexcept { return nodes_; }
  /// The strain modes of a mixed cell, from the displacements of its nodes and the values of gaps (GapLayout).
  [[nodiscard]] typename Shape::ModeValues modes_of(const Index<dim>& cell, const CellValues& u,
                                                    std::span<const double> of_gaps) const;
  /// The modes of a cell.
  [[nodiscard]] const typename Shape::ModeMatrix& modes() const noexcept { return modes_; }

  /// The unknowns of gaps.
  [[nodiscard]] const GapLayout& gap_layout() const noexcept { return gap_layout_; }
  /// The cells with gaps, if there are any.
  [[nodiscard]] const gaps::GapCells<dim>& gap_cells() const noexcept { return *gaps_; }
  /// The cell with gaps at a cell; null for other cells.
  [[nodiscard]] const gaps::GapCell<dim>* gap_cell(const Index<dim>& cell) const noexcept {
    return gaps_ != nullptr ? gaps_->at(cell) : nullptr;
  }

  /// A sparse matrix with the pattern of K on w, without values.
  [[nodiscard]] Matrix make_matrix() const;
  /// Assembles K into a matrix of make_matrix(). Held components of w are coupled to nothing and get a diagonal entry.
  void assemble(std::span<const Moduli> moduli, Mat matrix) const;
  /// Attaches the rigid motions to a matrix as its near null space, for algebraic multigrid.
  void attach_rigid_motions(Mat matrix) const { nodes_.attach_rigid_motions(matrix); }

 private:
  void find_first_strains();
  [[nodiscard]] std::vector<PetscInt> natural_indices_of_strains() const;
  /// Calls action(cell, mixed cell, index of its first unknown strain) for the mixed cells of this process.
  template <class Action>
  void for_mixed_cells(Action&& action) const;

  [[nodiscard]] std::int64_t gap_unknowns() const noexcept { return gaps_ != nullptr ? gaps_->unknowns() : 0; }
  /// The values of gaps (GapLayout) in a displacement with this gradient everywhere, without flow.
  [[nodiscard]] std::vector<double> gaps_in_linear_motion(const Eigen::Matrix<double, dim, dim>& gradient) const;
  /// The forces on the nodes of a mixed cell that has these stresses; adds those on its gaps.
  [[nodiscard]] CellValues forces_of(const Index<dim>& cell, const typename Shape::ModeValues& stress,
                                     std::span<double> on_gaps) const;

  std::shared_ptr<const gaps::GapCells<dim>> gaps_;  ///< the cells with gaps; null where there are none
  NodeLayout<dim> nodes_;
  CellKinds<dim> kinds_;
  GapLayout gap_layout_;
  int threads_;
  /// Index of the first strain of the mixed cells, by plane of cells of this process.
  std::vector<std::size_t> first_strain_;
  typename Shape::ModeMatrix modes_ = Shape::mode_matrix();
};

template <int dim>
template <class Action>
void ElasticOperator<dim>::for_mixed_cells_of_planes(int first_plane, int end_plane, Action&& action) const {
  auto [from, to] = nodes_.cells();
  to.back() = from.back() + end_plane;
  from.back() += first_plane;
  auto index = first_strain_[static_cast<std::size_t>(first_plane)];
  for_each_index(from, to, [&](const Index<dim>& cell) {
    const auto* mixed = kinds_.mixed_cell(cell);
    if (mixed == nullptr) return;
    action(cell, *mixed, index);
    index += static_cast<std::size_t>(mixed->unknowns());
  });
}

extern template class ElasticOperator<2>;
extern template class ElasticOperator<3>;

}  // namespace breccia::quasistatic
