#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// A number for the volumetric strain, and one for the deviators.
using VolumeAndShear = Eigen::Array2d;

/// The way in which the phases of a mixed cell act together (theory, Eqs. 40 and 40a). All are in series, unless all
/// phases of the composite are softer in shear than its matrix at all times, or one of the cell is a void: then the
/// matrix, or another phase where a cell has no matrix, holds their strains near to that of the cell, by the constraint
/// of Hill.
class MixtureRule {
 public:
  /// The phase that can hold others, by the order of phases that a stage has.
  static constexpr PhaseIndex matrix = 0;

  /// All phases in series.
  explicit MixtureRule(Mixture mixture);
  /// All phases in series, with shares in the mean strain that are not those of the area, and need not add up to 1.
  MixtureRule(Mixture mixture, std::vector<VolumeAndShear> shares)
      : mixture_(std::move(mixture)), shares_(std::move(shares)) {}
  /// The rule for these materials, by PhaseIndex.
  MixtureRule(Mixture mixture, std::span<const Material> by_phase);

  [[nodiscard]] const Mixture& mixture() const noexcept { return mixture_; }
  /// The shares of the phases in the mean strain [-].
  [[nodiscard]] const std::vector<VolumeAndShear>& shares() const noexcept { return shares_; }
  /// Whether a phase holds the strains of the others.
  [[nodiscard]] bool is_held() const noexcept { return holding_.has_value(); }

  /// The modulus c [Pa] with which a phase holds the strains of all; 0 in series.
  [[nodiscard]] VolumeAndShear constraint(std::span<const Moduli> by_phase) const {
    return holding_ ? VolumeAndShear(by_phase[*holding_].shear * of_unit_shear()) : VolumeAndShear::Zero();
  }
  /// m + c for each phase of the mixture, in its order [Pa].
  template <int dim>
  [[nodiscard]] std::vector<VolumeAndShear> constrained(std::span<const Moduli> by_phase) const;
  /// M + c of the mixture, for those of its phases [Pa]: phases in series. If one of them is 0, that of the mixture is.
  [[nodiscard]] VolumeAndShear in_series(std::span<const VolumeAndShear> constrained) const;
  /// The moduli of the mixture [Pa].
  template <int dim>
  [[nodiscard]] Moduli moduli(std::span<const Moduli> by_phase) const;

  /// The mixture as a material: its moduli are exact, by the correspondence principle, and its density is the mean
  /// density. In plane strain its bulk modulus K, the difference of the dilatational modulus K + G/3 and of G/3, may
  /// have negative terms. Throws InputError where a dilatational or a shear modulus of a phase has negative terms, and
  /// NumericalError where rounding would make terms of the mixture negative.
  template <int dim>
  [[nodiscard]] Material material(std::span<const Material> by_phase) const;

 private:
  /// The constraint of a phase with a shear modulus of 1.
  [[nodiscard]] static VolumeAndShear of_unit_shear() noexcept {
    constexpr double of_volume = 3.0, of_shear = 10.0;  // chosen on arrays of soft discs (theory, section 2)
    return {of_volume, of_shear};
  }
  /// The modulus of a mode of VolumeAndShear.
  template <int dim>
  [[nodiscard]] PronySeries modulus(std::span<const Material> by_phase, PronySeries (*of_phase)(const Material&),
                                    Eigen::Index mode) const;

  Mixture mixture_;
  std::vector<VolumeAndShear> shares_;
  std::optional<PhaseIndex> holding_;  ///< the phase that holds the strains of all; nothing in series
};

}  // namespace breccia
