#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/solvers/lattice/lattice_boundary.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"
#include "quasistatic/solvers/saddle_point/cell_volumes.hpp"
#include "quasistatic/solvers/saddle_point/gap_forms.hpp"

namespace breccia::quasistatic {

/// The elastic operator of a box of cubes with gaps as a saddle point: the pressures of cells are unknowns beside the
/// displacements w, which have the values of gaps,
///
///     A w + B' p = f,   B w - p / k = g.
///
/// B gives the volume changes of the cells, p is positive in tension, and k is their bulk modulus without what A has
/// of it: 2/3 of the shear modulus, in cells without gaps. With the pressures eliminated, and g = 0, it is K w = f. The
/// box is periodic, and all of it is on one process.
class SaddlePointOperator {
 public:
  /// Throws InputError for several processes and for boundaries that are not periodic.
  explicit SaddlePointOperator(const ElasticOperator<3>& elastic_operator);

  /// Takes moduli [Pa], by material. Throws InputError for cells of several materials that are not mixed.
  void set_moduli(std::span<const Moduli> moduli);

  [[nodiscard]] const NodeLattice& lattice() const noexcept { return lattice_; }
  [[nodiscard]] LatticeBoundary& boundary() noexcept { return boundary_; }
  [[nodiscard]] int threads() const noexcept { return elastic_operator_->threads(); }
  /// A field of zeros.
  [[nodiscard]] NodalField zeros() const { return NodalField(lattice_, size() - 3 * lattice_.size()); }
  /// Number of entries of a field.
  [[nodiscard]] std::size_t size() const noexcept { return first_pressure() + cells_; }
  [[nodiscard]] std::size_t first_gap() const noexcept { return 3 * lattice_.size(); }
  [[nodiscard]] std::size_t first_pressure() const noexcept { return first_gap() + layout().seen(); }
  [[nodiscard]] std::size_t cells() const noexcept { return cells_; }
  [[nodiscard]] std::span<double> gaps(NodalField& field) const { return field.further().first(layout().seen()); }
  [[nodiscard]] std::span<double> pressures(NodalField& field) const { return field.further().last(cells_); }
  [[nodiscard]] std::span<const double> pressures(const NodalField& field) const {
    return field.further().last(cells_);
  }
  [[nodiscard]] const GapLayout& layout() const noexcept { return elastic_operator_->gap_layout(); }
  [[nodiscard]] const GapForms& forms() const noexcept { return forms_; }
  /// The stiffness of each term [Pa].
  [[nodiscard]] const std::vector<double>& stiffness_of_slopes() const noexcept { return stiffness_of_slopes_; }
  [[nodiscard]] const std::vector<double>& stiffness_of_flows() const noexcept { return stiffness_of_flows_; }
  /// The diagonals of the slopes and of the flows by value of a gap [Pa]; zero for values of the other kind.
  [[nodiscard]] const std::vector<double>& diagonal_of_slopes() const noexcept { return diagonal_of_slopes_; }
  [[nodiscard]] const std::vector<double>& diagonal_of_flows() const noexcept { return diagonal_of_flows_; }
  /// The moduli of cells without gaps that are like A.
  [[nodiscard]] const CellModuli& similar_cells() const noexcept { return similar_; }
  /// The moduli k [Pa] by kind of cell.
  [[nodiscard]] const std::vector<double>& bulk_of_pressures() const noexcept { return bulk_of_pressures_; }
  /// Whether a cell has a gap, so that its volume change is not that of its nodes.
  [[nodiscard]] bool has_gap(std::size_t cell) const noexcept { return has_no_gap_[kinds()[cell]] == 0.0; }
  /// The kinds of the cells.
  [[nodiscard]] const std::uint32_t* kinds() const noexcept { return similar_.kind_of.first; }

  /// product = (A w + B' p, B w - p / k); sets the repeated nodes of `field`.
  void multiply(NodalField& field, NodalField& product);
  /// product = A w of nodes for a box without gaps that is similar; further values are left out.
  void multiply_similar(NodalField& field, NodalField& product);

 private:
  [[nodiscard]] std::vector<double> diagonal_of(const SquareTerms& terms, const std::vector<double>& stiffness) const;
  void add_slab(int first_plane, int end_plane, const NodalField& field, NodalField& product, CellVolumes& row) const;

  const ElasticOperator<3>* elastic_operator_;
  NodeLattice lattice_;
  LatticeBoundary boundary_;
  CellSweep sweep_;
  GapForms forms_;
  std::size_t cells_;
  std::vector<double> has_no_gap_;  ///< by kind: 1 for cells without gaps, whose volume change is that of their nodes
  CellModuli moduli_, similar_;
  std::vector<double> bulk_of_pressures_, stiffness_of_slopes_, stiffness_of_flows_;
  std::vector<double> diagonal_of_slopes_, diagonal_of_flows_;
};

}  // namespace breccia::quasistatic
