#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "breccia/discretisation/mixture.hpp"

#include "discretisation/cell_shape.hpp"

namespace breccia::quasistatic {

/// The strain of a phase over that of its cell, for the volumetric strain and for all deviatoric modes.
struct StrainShare {
  double volumetric, deviatoric;
};

/// A cell that holds several phases in series. Each phase k has strains y_k of its own (CellShape::mode_matrix), whose
/// mean is the strain of the cell, s = sum of f_k y_k. The energy, half the sum of f_k (G_k |dev y_k|^2 + k_k vol
/// y_k^2) with the dilatational modulus k, is affine in the moduli; where it is a minimum, all phases have one stress,
/// and the moduli of the cell are those of the series mixture (theory, Eqs. 40 to 42). The strains of all phases except
/// the first are unknowns, one after the other; the strains of the first phase follow from them.
template <int dim>
class MixedCell {
 public:
  using Shape = CellShape<dim>;
  using Modes = typename Shape::ModeValues;
  using Strains = Eigen::Map<const Eigen::VectorXd>;

  explicit MixedCell(Mixture mixture) : mixture_(std::move(mixture)) {}

  [[nodiscard]] const Mixture& mixture() const noexcept { return mixture_; }
  /// Number of the unknown strains of this cell, or of a cell with a given mixture.
  [[nodiscard]] Eigen::Index unknowns() const noexcept { return unknowns_of(mixture_); }
  [[nodiscard]] static Eigen::Index unknowns_of(const Mixture& mixture) noexcept {
    return Shape::modes * (static_cast<Eigen::Index>(mixture.size()) - 1);
  }

  /// The strains of all phases if each of them has the strain of the cell.
  [[nodiscard]] Eigen::VectorXd uniform(const Modes& strain) const;
  /// The strain of the phase at an index in the mixture, from the strain of the cell and the unknown strains.
  [[nodiscard]] Modes strain_of(std::size_t part, const Modes& strain, const Strains& unknown) const;
  /// The stress conjugate to the strain of the cell, and the forces conjugate to the unknown strains, for the moduli
  /// [Pa] of the phases.
  [[nodiscard]] std::pair<Modes, Eigen::VectorXd> stresses(std::span<const Moduli> moduli, const Modes& strain,
                                                           const Strains& unknown) const;
  /// Static condensation: the reduction of the stress of the series mixture by forces on the unknown strains, when
  /// these strains have been eliminated. It is the sum in Eq. 42 of the theory, times the modulus of the mixture.
  [[nodiscard]] Modes stress_relieved_by(std::span<const Moduli> moduli, const Strains& forces) const;
  /// The shares of all phases except the first where no forces act on the strains, for the moduli [Pa] of the phases.
  [[nodiscard]] std::vector<StrainShare> shares(std::span<const Moduli> moduli) const;
  /// The unknown strains that are in equilibrium with these forces on them.
  [[nodiscard]] Eigen::VectorXd strains_under(std::span<const Moduli> moduli, const Modes& strain,
                                              const Strains& forces) const;

 private:
  Mixture mixture_;
};

extern template class MixedCell<2>;
extern template class MixedCell<3>;

}  // namespace breccia::quasistatic
