#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// A number for the volumetric strain, and one for the deviators.
using VolumeAndShear = Eigen::Array2d;

/// The way in which the phases of a mixed cell act together (theory, Eqs. 40 and 40a). Each phase surrounds all that
/// come after it in the mixture. It is in series with them; but where it is stiffer than all of them in shear, at all
/// times, it holds their strains near to its own, by the constraint of Hill.
class MixtureRule {
 public:
  /// All phases in series.
  explicit MixtureRule(Mixture mixture) : mixture_(std::move(mixture)), holds_(mixture_.size() - 1, false) {}
  /// The rule for these materials, by PhaseIndex.
  MixtureRule(Mixture mixture, std::span<const Material> by_phase);

  [[nodiscard]] const Mixture& mixture() const noexcept { return mixture_; }
  /// Whether the phase at an index in the mixture holds the strains of those that it surrounds. The last phase
  /// surrounds none.
  [[nodiscard]] bool holds(std::size_t part) const { return part < holds_.size() && holds_[part]; }

  /// Constraint of the strains inside a phase with this shear modulus [Pa].
  [[nodiscard]] static VolumeAndShear constraint(double shear) noexcept {
    constexpr double of_volume = 3.0, of_shear = 10.0;
    return {of_volume * shear, of_shear * shear};
  }

  /// A phase and all that it surrounds. With a constraint, all moduli include it.
  struct Level {
    double fraction;            ///< share of the phase and of what it surrounds in the cell [-]
    VolumeAndShear phase;       ///< moduli of the phase [Pa]
    VolumeAndShear surrounded;  ///< moduli of what it surrounds [Pa]
    VolumeAndShear both;        ///< moduli of both together [Pa]
  };
  /// The levels, from the outside inwards, one for each phase except the last. If a modulus of a phase in series is 0,
  /// that of the mixture is 0.
  template <int dim>
  [[nodiscard]] std::vector<Level> levels(std::span<const Moduli> by_phase) const;
  /// The moduli of the mixture [Pa].
  template <int dim>
  [[nodiscard]] Moduli moduli(std::span<const Moduli> by_phase) const;

  /// The mixture as a material: its moduli are exact, by the correspondence principle, and its density is the mean
  /// density. In plane strain its bulk modulus K, the difference of the dilatational modulus K + G/3 and of G/3, may
  /// have negative terms. Throws InputError where a dilatational or a shear modulus of a phase has negative terms.
  template <int dim>
  [[nodiscard]] Material material(std::span<const Material> by_phase) const;

 private:
  template <int dim>
  [[nodiscard]] PronySeries modulus(std::span<const Material> by_phase, PronySeries (*of_phase)(const Material&),
                                    double constraint) const;

  Mixture mixture_;
  std::vector<bool> holds_;  ///< by part, without the last one
};

}  // namespace breccia
