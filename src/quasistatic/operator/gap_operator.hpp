#pragma once

#include <span>

#include <Eigen/Core>

#include "discretisation/cell_shape.hpp"
#include "discretisation/gaps/gap_cell.hpp"
#include "quasistatic/operator/gap_layout.hpp"

namespace breccia::quasistatic {

/// A cell with gaps as the elastic operator sees it. Its strain modes are those of CellShape, of which the last one,
/// the volume change, depends on the unknowns of its gaps, too.
template <int dim>
class GapOperator {
 public:
  using Shape = CellShape<dim>;
  using Modes = typename Shape::ModeValues;
  using Unknowns = gaps::CellUnknowns<dim>;
  using Stiffness = Eigen::Matrix<double, gaps::unknowns_of_cell<dim>, gaps::unknowns_of_cell<dim>>;

  GapOperator(const gaps::GapCell<dim>& cell, const typename Shape::ModeMatrix& modes) : cell_(&cell), modes_(&modes) {}

  /// The unknowns from the displacements of the nodes and the values of gaps (GapLayout).
  [[nodiscard]] Unknowns unknowns(const typename Shape::Values& of_nodes, const GapLayout& layout,
                                  std::span<const double> of_gaps) const noexcept;
  [[nodiscard]] Modes strain(const Unknowns& unknowns) const noexcept;
  /// The volume change [-].
  [[nodiscard]] double volume(const Unknowns& unknowns) const noexcept { return cell_->volume.dot(unknowns); }
  /// Adds the forces on the unknowns of stresses conjugate to the modes.
  void add_forces_of(const Modes& stress, Unknowns& forces) const noexcept;
  /// Adds the forces of the flow and of the ties of the slopes, for the moduli [Pa] of the phases.
  void add_forces_of_terms(std::span<const Moduli> moduli, const Unknowns& unknowns, Unknowns& forces) const noexcept;
  /// Adds forces to those on gaps (GapLayout).
  void add_to_gaps(const Unknowns& forces, const GapLayout& layout, std::span<double> on_gaps) const noexcept;
  /// The stiffness for the moduli [Pa] of the cell and of the phases.
  [[nodiscard]] Stiffness stiffness(const Moduli& of_cell, std::span<const Moduli> moduli) const;

 private:
  const gaps::GapCell<dim>* cell_;
  const typename Shape::ModeMatrix* modes_;
};

extern template class GapOperator<2>;
extern template class GapOperator<3>;

}  // namespace breccia::quasistatic
