#pragma once

#include <cstddef>
#include <cstdint>

#include "breccia/virtual_test/curve.hpp"

namespace breccia {

/// One dynamic run with one mass scaling factor.
struct TimeDomain {
  double mass_scaling = 1.0;  ///< [-]
  double time_step = 0.0;     ///< [s]
  double ramp = 0.0;          ///< duration of the ramp [s]
  TimeWindow window;          ///< times at which the run is valid [s]
  std::int64_t steps = 0;
  std::size_t terms = 0;  ///< largest number of integrated Prony terms of a material
  /// Bound on the relative error of the moduli by the neglected Prony terms [-], from the expected start of the
  /// validity of the run on. A first run with a given mass scaling factor may be used earlier (theory, section 4).
  double reduction_error = 0.0;
  double seconds = 0.0;  ///< wall time [s]
  /// The modulus [Pa] from the start of the ramp on, or the reciprocal of the creep compliance, 1 / J(t), from the end
  /// of the ramp on. Each sample is a mean over a few steps.
  Curve history;

  [[nodiscard]] double point_steps_per_second(std::size_t points) const {
    return static_cast<double>(points) * static_cast<double>(steps) / seconds;
  }
};

/// The times at which two neighbouring domains are both valid.
struct Overlap {
  TimeWindow window;      ///< times that both domains cover [s]
  double mismatch = 0.0;  ///< largest relative difference of the two curves in it [-]
};

}  // namespace breccia
