#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// There-and-back transits of the shear wave after which a dynamic run is taken as quasi-static (the paper's three).
constexpr double there_and_back_transits = 3.0;

/// What decides which density factors a curve needs.
struct DomainRules {
  double side = 0.0;                    ///< of the box [m]
  double density = 0.0;                 ///< mean, before scaling [kg/m^3]
  TimeWindow times;                     ///< requested
  std::vector<double> density_factors;  ///< given, rising; empty: chosen
  double factor_ratio = 10.0;           ///< of neighbouring factors where they are chosen
  double overlap = 1.5;                 ///< ratio of times for which a run goes on beside the next one
  double longest = 100.0;               ///< largest ratio of times in one domain, from where it is expected to be valid

  /// Largest density factor with which a run is valid at a time when the composite's shear modulus is `modulus` [Pa]:
  /// s = (t / 6 L)^2 G(t) / density (theory, Eq. 14).
  [[nodiscard]] double admissible_factor(double time, double modulus) const;
  /// Time [s] that the shear wave takes through the box.
  [[nodiscard]] double transit(double density_factor, double modulus) const;
};

/// Chooses density factors one after the other, while the curve that they need becomes known.
///
/// A domain with factor s is valid while s is at most the admissible factor. It hands over when the next factor has
/// been admissible for the ratio of times `overlap`. Where the composite relaxes so fast that the admissible factor
/// falls again, factors that are chosen fall with it.
class DomainSequence {
 public:
  /// `modulus` is a lower estimate of the composite's shear modulus at the first requested time [Pa].
  DomainSequence(DomainRules rules, double modulus);

  [[nodiscard]] double density_factor() const noexcept { return factor_; }
  /// Where the present domain is expected to become valid [s].
  [[nodiscard]] double expected_begin() const noexcept { return expected_begin_; }
  /// Time [s] that the present domain will not go beyond.
  [[nodiscard]] double last_time() const;
  /// Where the present domain has been found valid so far; empty before.
  [[nodiscard]] std::optional<TimeWindow> window() const noexcept { return window_; }

  /// Takes note of the composite's shear modulus at a time, times rising. Returns false when the domain is over: either
  /// the last time requested is reached, or the next domain can take over.
  /// Throws NumericalError when the first domain becomes valid only after the first time requested.
  [[nodiscard]] bool observe(double time, double modulus);

  [[nodiscard]] bool is_first() const noexcept { return is_first_; }
  [[nodiscard]] bool is_complete() const noexcept { return complete_; }
  /// Goes on to the next domain.
  /// Throws NumericalError when the present one never was valid, or no given factor is left, naming times and factors.
  void advance();

 private:
  [[nodiscard]] std::optional<double> next_factor() const;
  [[noreturn]] void throw_late(double time) const;

  DomainRules rules_;
  double factor_ = 1.0;
  double expected_begin_;
  double lowest_admissible_ = std::numeric_limits<double>::infinity();  ///< in the present domain
  double furthest_ = 0.0;                                               ///< end of the windows so far [s]
  std::size_t given_ = 0;  ///< index of the present factor among the given ones
  bool rising_ = true;
  bool is_first_ = true;
  bool expired_ = false;
  bool complete_ = false;
  std::optional<TimeWindow> window_;
  std::optional<double> next_admissible_;
};

}  // namespace breccia
