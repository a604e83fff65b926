#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"

#include "discretisation/cell_shape.hpp"
#include "discretisation/gaps/gap_cells.hpp"
#include "quasistatic/operator/mixed_cell.hpp"
#include "quasistatic/operator/node_layout.hpp"

namespace breccia::quasistatic {

/// The kinds of the cells of a process. Cells of one kind have the same materials at the same points, and so one
/// stiffness: that of Volumetric::averaged or ::standard points, or that of the mixture of a mixed cell.
template <int dim>
class CellKinds {
 public:
  using Shape = CellShape<dim>;
  using Stiffness = typename Shape::Stiffness;

  /// The materials, by PhaseIndex, decide the rule of each mixture; without them all phases are in series. A cell with
  /// gaps is a kind of its own: a mixed cell with the shares of its phases. Throws InputError when a point has no
  /// phase, for mixed cells with the volumetric strains of points, and for mixed cells with crystals.
  CellKinds(const Discretisation<dim>& discretisation, Volumetric volumetric, const IndexRange<dim>& own_cells,
            const Crystals& crystals = {}, std::span<const Material> materials = {},
            const gaps::GapCells<dim>* gaps = nullptr);

  /// Number of kinds.
  [[nodiscard]] std::size_t count() const noexcept { return phases_.size(); }
  /// The kind of a cell.
  [[nodiscard]] std::uint32_t of(const Index<dim>& cell) const noexcept { return of_cells_[own_cells_.place_of(cell)]; }
  /// The kinds of all cells, the first axis fastest.
  [[nodiscard]] const std::vector<std::uint32_t>& of_cells() const noexcept { return of_cells_; }
  /// The mixed cells by kind; nothing for kinds of cells that are not mixed.
  [[nodiscard]] const std::vector<std::optional<MixedCell<dim>>>& mixed() const noexcept { return mixed_; }
  /// Whether the cells of a kind have gaps.
  [[nodiscard]] bool has_gaps(std::size_t kind) const noexcept { return has_gaps_[kind]; }
  /// The mixed cell of a cell; null if the cell is not mixed.
  [[nodiscard]] const MixedCell<dim>* mixed_cell(const Index<dim>& cell) const noexcept {
    const auto& mixed = mixed_[of(cell)];
    return mixed ? &*mixed : nullptr;
  }
  /// Number of the unknown strains of all mixed cells of the box before each row of cells.
  [[nodiscard]] const std::vector<PetscInt>& strains_before_rows() const noexcept { return strains_before_rows_; }

  /// Stiffness of the cells of a kind [Pa], for moduli [Pa] by material. Crystals have their own stiffness where their
  /// moduli are softer_moduli(), and no stiffness where these are 0, as in the parts of an affine stiffness that vary.
  [[nodiscard]] Stiffness stiffness(std::size_t kind, std::span<const Moduli> moduli) const;
  /// The stiffnesses of all kinds; zero for kinds of cells with gaps, which have further unknowns.
  [[nodiscard]] std::vector<Stiffness> stiffnesses(std::span<const Moduli> moduli) const;
  /// Moduli [Pa] of the cells of a kind, if all points have the same moduli and the stiffness is that of averaged
  /// volumetric strains.
  [[nodiscard]] std::optional<Moduli> uniform_moduli(std::size_t kind, std::span<const Moduli> moduli) const;
  /// Whether the cells of a kind are nothing but void, for moduli by material.
  [[nodiscard]] bool is_empty(std::size_t kind, std::span<const Moduli> moduli) const;

 private:
  /// The stiffness of a crystal, and the shear modulus that represents it in lists of moduli [Pa].
  struct Crystal {
    StiffnessTensor<dim> stiffness;
    double shear;
  };

  std::uint32_t add_kind(const CellPhases<dim>& phases, std::optional<MixedCell<dim>> mixed);
  [[nodiscard]] bool has_crystals(std::size_t kind) const;
  [[nodiscard]] StiffnessTensor<dim> tensor(PhaseIndex phase, const Moduli& moduli) const;

  Volumetric volumetric_;
  IndexRange<dim> own_cells_;
  std::vector<CellPhases<dim>> phases_;               ///< phases of the points of a cell, by kind
  std::vector<std::optional<MixedCell<dim>>> mixed_;  ///< mixed cells by kind
  std::vector<bool> has_gaps_;                        ///< whether the cells of a kind have gaps
  std::vector<std::uint32_t> of_cells_;
  std::vector<PetscInt> strains_before_rows_;
  std::map<PhaseIndex, Crystal> crystals_;
};

extern template class CellKinds<2>;
extern template class CellKinds<3>;

}  // namespace breccia::quasistatic
