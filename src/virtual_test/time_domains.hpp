#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// There-and-back transits of the shear wave after which a dynamic run is taken as quasi-static (three, as in the
/// paper).
constexpr double there_and_back_transits = 3.0;

/// The parameters by which mass scaling factors are chosen for a curve.
struct DomainRules {
  double side = 0.0;                         ///< side of the box [m]
  double density = 0.0;                      ///< mean density before scaling [kg/m^3]
  TimeWindow times;                          ///< requested times [s]
  std::vector<double> mass_scaling_factors;  ///< rising factors given by the user [-]; empty: chosen by the program
  double factor_ratio = 10.0;                ///< ratio of neighbouring factors if the program chooses them [-]
  double overlap = 1.5;                      ///< ratio of times over which two neighbouring runs overlap [-]
  double longest = 100.0;                    ///< largest ratio of end time to expected begin of validity of a run [-]

  /// Largest mass scaling factor with which a run is valid at a time when the composite's shear modulus is `modulus`
  /// [Pa]: (t / 6 L)^2 G(t) / density (theory, Eq. 14).
  [[nodiscard]] double admissible_factor(double time, double modulus) const;
  /// Latest time [s] to which a run is continued that is valid from a time on.
  [[nodiscard]] double last_time(double begin) const;
  /// Time [s] that the shear wave takes through the box.
  [[nodiscard]] double transit(double mass_scaling, double modulus) const;
};

/// Chooses mass scaling factors one after the other from the curve while it is computed.
///
/// A domain is valid while its factor is at most the admissible factor. It ends when the next factor has been
/// admissible for the ratio of times `overlap`. If the composite relaxes so fast that the admissible factor falls
/// again, the factors that the program chooses fall with it.
class DomainSequence {
 public:
  /// `modulus` is a lower estimate of the composite's shear modulus at the first requested time [Pa].
  DomainSequence(DomainRules rules, double modulus);

  [[nodiscard]] double mass_scaling() const noexcept { return factor_; }
  /// Time [s] at which the present domain is expected to become valid.
  [[nodiscard]] double expected_begin() const noexcept { return expected_begin_; }
  /// Latest time [s] to which the present domain can run.
  [[nodiscard]] double last_time() const;
  /// Times at which the present domain has been valid so far [s]; nothing if it has not been valid yet.
  [[nodiscard]] std::optional<TimeWindow> window() const noexcept { return window_; }

  /// Records the composite's shear modulus [Pa] at a time [s]; times must rise. Returns false when the domain is
  /// finished: the last requested time is reached, or the next domain is valid.
  /// Throws NumericalError when the first domain becomes valid only after the first requested time.
  [[nodiscard]] bool observe(double time, double modulus);

  [[nodiscard]] bool is_first() const noexcept { return is_first_; }
  /// Whether the last requested time has been reached.
  [[nodiscard]] bool is_complete() const noexcept { return complete_; }
  /// Begins the next domain.
  /// Throws NumericalError, with times and factors, when the present domain was never valid or no given factor is left.
  void advance();

 private:
  [[nodiscard]] std::optional<double> next_factor() const;
  [[noreturn]] void throw_late(double time) const;

  DomainRules rules_;
  double factor_ = 1.0;
  double expected_begin_;
  /// Lowest admissible factor in the present domain.
  double lowest_admissible_ = std::numeric_limits<double>::infinity();
  double furthest_ = 0.0;  ///< end of the windows so far [s]
  std::size_t given_ = 0;  ///< index of the present factor among the given ones
  bool rising_ = true;
  bool is_first_ = true;
  bool expired_ = false;
  bool complete_ = false;
  std::optional<TimeWindow> window_;
  std::optional<double> next_admissible_;
};

}  // namespace breccia
