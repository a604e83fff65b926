#pragma once

#include <cstddef>
#include <limits>
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
/// phases of the composite are softer in shear than its matrix at all times: then the matrix holds their strains near
/// to its own, by the constraint of Hill.
class MixtureRule {
 public:
  /// The phase that can hold others, by the order of phases that a stage has.
  static constexpr PhaseIndex matrix = 0;

  /// All phases in series.
  explicit MixtureRule(Mixture mixture) : mixture_(std::move(mixture)) {}
  /// The rule for these materials, by PhaseIndex.
  MixtureRule(Mixture mixture, std::span<const Material> by_phase);

  /// The phases. Where the matrix holds the others, it is the first.
  [[nodiscard]] const Mixture& mixture() const noexcept { return mixture_; }
  /// Whether the phase at an index in the mixture holds the strains of those after it.
  [[nodiscard]] bool holds(std::size_t part) const noexcept { return part == holder_; }

  /// Constraint of the strains that a matrix with this shear modulus [Pa] holds.
  [[nodiscard]] static VolumeAndShear constraint(double shear) noexcept {
    constexpr double of_volume = 3.0, of_shear = 10.0;  // chosen on arrays of soft discs (theory, section 2)
    return {of_volume * shear, of_shear * shear};
  }

  /// A phase and all after it. With a constraint, all moduli include it.
  struct Level {
    double fraction;       ///< share of the phase and of those after it in the cell [-]
    VolumeAndShear phase;  ///< moduli of the phase [Pa]
    VolumeAndShear later;  ///< moduli of those after it [Pa]
    VolumeAndShear both;   ///< moduli of both together [Pa]
  };
  /// The levels, one for each phase except the last. If a modulus of a phase in series is 0, that of the mixture is 0.
  template <int dim>
  [[nodiscard]] std::vector<Level> levels(std::span<const Moduli> by_phase) const;
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
  template <int dim>
  [[nodiscard]] PronySeries modulus(std::span<const Material> by_phase, PronySeries (*of_phase)(const Material&),
                                    double constraint) const;

  Mixture mixture_;
  std::size_t holder_ = std::numeric_limits<std::size_t>::max();  ///< index of the matrix, if it holds others
};

}  // namespace breccia
