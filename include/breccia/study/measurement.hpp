#pragma once

#include <optional>
#include <string>
#include <variant>

#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A shear relaxation modulus that was measured, to be compared with that of a stage.
struct Measurement {
  std::string label;
  std::string stage;                       ///< the name of the one that stands for what was measured
  std::variant<PronySeries, Curve> shear;  ///< [Pa]
  std::optional<TimeWindow> times = {};    ///< in which it holds [s]

  /// The times [s] in a window at which it tells the modulus; nothing where the two have none in common.
  [[nodiscard]] std::optional<TimeWindow> known_within(const TimeWindow& window) const;
  /// Measured modulus [Pa] at one of them; between the points of a curve a power of time.
  [[nodiscard]] double at(double time) const;
};

}  // namespace breccia
