#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/tables/modulus_kind.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A measured complex modulus M' + i M''.
struct MeasuredModulus {
  double angular_frequency = 0.0;  ///< [rad/s]
  double storage = 0.0;            ///< M' [Pa]
  double loss = 0.0;               ///< M'' [Pa]
};

/// A measured relaxation modulus, to be compared with that of a stage.
struct Measurement {
  std::string label;
  std::string stage;                         ///< name of the stage that models the measured material
  std::variant<PronySeries, Curve> modulus;  ///< [Pa]
  std::optional<TimeWindow> times = {};      ///< times for which the measurement is valid [s]
  /// The moduli at the measured frequencies, rising, where these were measured and `modulus` is fitted to them.
  std::vector<MeasuredModulus> dynamic = {};
  ModulusKind kind = ModulusKind::shear;  ///< G, K, or E

  /// The part of a window of times [s] in which the measured modulus is known; nothing if there is none.
  [[nodiscard]] std::optional<TimeWindow> known_within(const TimeWindow& window) const;
  /// The times of the measured points in that part [s], 1/omega of those in frequency; none of a series without them.
  [[nodiscard]] std::vector<double> points_within(const TimeWindow& window) const;
  /// Measured modulus [Pa] at a time [s] in that part; interpolated between the points of a curve as a power of time.
  [[nodiscard]] double at(double time) const;
  /// The complex moduli at the measured frequencies 1/t for times t in that part of a window. Where none were measured,
  /// those of the series at the given angular frequencies [rad/s] in that part; nothing for a curve, and for an elastic
  /// modulus, which has no loss.
  [[nodiscard]] std::vector<MeasuredModulus> complex_within(const TimeWindow& window,
                                                            const std::vector<double>& angular_frequencies) const;
};

}  // namespace breccia
