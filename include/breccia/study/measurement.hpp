#pragma once

#include <optional>
#include <string>
#include <variant>

#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A measured shear relaxation modulus, to be compared with that of a stage.
struct Measurement {
  std::string label;
  std::string stage;                       ///< name of the stage that models the measured material
  std::variant<PronySeries, Curve> shear;  ///< [Pa]
  std::optional<TimeWindow> times = {};    ///< times for which the measurement is valid [s]

  /// The part of a window of times [s] in which the measured modulus is known; nothing if there is none.
  [[nodiscard]] std::optional<TimeWindow> known_within(const TimeWindow& window) const;
  /// Measured modulus [Pa] at a time [s] in that part; interpolated between the points of a curve as a power of time.
  [[nodiscard]] double at(double time) const;
};

}  // namespace breccia
