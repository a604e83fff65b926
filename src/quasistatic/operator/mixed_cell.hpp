#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "discretisation/cell_shape.hpp"
#include "discretisation/mixture_rule.hpp"

namespace breccia::quasistatic {

/// The strain of a phase over that of its cell, for the volumetric strain and for all deviatoric modes.
struct StrainShare {
  double volumetric, deviatoric;
};

/// A cell that holds several phases. Each phase k has strains y_k of its own (CellShape::mode_matrix), whose mean is
/// the strain of the cell, s = sum of f_k y_k by the shares of its MixtureRule. The energy (theory, Eqs. 41 and 41a) is
/// affine in the moduli; where it is a minimum, the cell has the moduli of its MixtureRule. The strains of all phases
/// except the first are unknowns, one after the other; the strains of the first phase follow from them.
template <int dim>
class MixedCell {
 public:
  using Shape = CellShape<dim>;
  using Modes = typename Shape::ModeValues;
  using Strains = Eigen::Map<const Eigen::VectorXd>;

  explicit MixedCell(MixtureRule rule) : rule_(std::move(rule)) {}

  [[nodiscard]] const Mixture& mixture() const noexcept { return rule_.mixture(); }
  /// Number of the unknown strains of this cell, or of a cell with a given mixture.
  [[nodiscard]] Eigen::Index unknowns() const noexcept { return unknowns_of(mixture()); }
  [[nodiscard]] static Eigen::Index unknowns_of(const Mixture& mixture) noexcept {
    return Shape::modes * (static_cast<Eigen::Index>(mixture.size()) - 1);
  }

  [[nodiscard]] const MixtureRule& rule() const noexcept { return rule_; }
  /// Moduli of the cell [Pa], for those of the phases. If a modulus of a phase in series is 0, that of the cell is 0.
  [[nodiscard]] Moduli moduli(std::span<const Moduli> by_phase) const { return rule_.moduli<dim>(by_phase); }

  /// The share of the strain of the cell that all phases have if all of them have the same strain.
  [[nodiscard]] StrainShare uniform_share() const;
  /// The strains of all phases if all of them have the same.
  [[nodiscard]] Eigen::VectorXd uniform(const Modes& strain) const;
  /// The mean stress of the cell, which is conjugate to a uniform strain of all phases, from the stresses of the
  /// phases: their weights.
  [[nodiscard]] Modes weight_of_stress(std::size_t part) const { return of_share(part).cwiseQuotient(of_all_shares()); }
  /// The strain of the phase at an index in the mixture, from the strain of the cell and the unknown strains.
  [[nodiscard]] Modes strain_of(std::size_t part, const Modes& strain, const Strains& unknown) const;
  /// The stress conjugate to the strain of the cell, and the forces conjugate to the unknown strains, for the moduli
  /// [Pa] of the phases.
  [[nodiscard]] std::pair<Modes, Eigen::VectorXd> stresses(std::span<const Moduli> moduli, const Modes& strain,
                                                           const Strains& unknown) const;
  /// Static condensation: the reduction of the stress of the cell by forces on the unknown strains, when these strains
  /// have been eliminated (theory, Eq. 42).
  [[nodiscard]] Modes stress_relieved_by(std::span<const Moduli> moduli, const Strains& forces) const;
  /// The shares of all phases except the first where no forces act on the strains, for the moduli [Pa] of the phases.
  [[nodiscard]] std::vector<StrainShare> shares(std::span<const Moduli> moduli) const;
  /// The unknown strains that are in equilibrium with these forces on them (theory, Eq. 42).
  [[nodiscard]] Eigen::VectorXd strains_under(std::span<const Moduli> moduli, const Modes& strain,
                                              const Strains& forces) const;

 private:
  [[nodiscard]] static Modes of_modes(const VolumeAndShear& values);
  [[nodiscard]] Modes of_share(std::size_t part) const { return of_modes(rule_.shares()[part]); }
  [[nodiscard]] Modes of_all_shares() const;
  /// The values of a part, not the first one, among those of all parts except the first.
  template <class Values>
  [[nodiscard]] static auto segment(std::size_t part, Values& values) {
    return values.template segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(part) - 1));
  }

  MixtureRule rule_;
};

extern template class MixedCell<2>;
extern template class MixedCell<3>;

}  // namespace breccia::quasistatic
