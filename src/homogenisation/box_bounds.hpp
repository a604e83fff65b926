#pragma once

#include <optional>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The apparent moduli of a box under displacement and traction at one time. They are bounds of the effective modulus,
/// on the average over boxes, where the box is a window in a larger body.
struct BoundsAtTime {
  double time = 0.0;                   ///< [s]
  std::optional<double> upper, lower;  ///< under displacement, under traction [Pa]; nothing for one that was not tested
  std::optional<double> grid_half_band;  ///< larger half band of the extrapolations to vanishing cells [Pa]

  /// upper / lower - 1 [-]; nothing unless both were tested.
  [[nodiscard]] std::optional<double> distance() const;
  /// 1 - upper / lower [-] where the upper modulus is below the lower one by more than the half bands of both; nothing
  /// otherwise. Bounds that cross each other are no bounds: one of the tests is wrong.
  [[nodiscard]] std::optional<double> crossing() const;
};

/// The bounds under one load and by one method; with several grids the extrapolated bounds.
struct LoadQuality {
  TestLoad load = Load::shear;
  Method method = Method::quasistatic;
  std::vector<BoundsAtTime> times;  ///< bounds at both ends of the curves and at each decade between them
};

/// Half width of the error band of an extrapolated test [Pa], at its time nearest to the given one [s]; nothing for
/// another test.
std::optional<double> half_band(const TestResult& test, double time);

/// The moduli under displacement and traction of all loads and methods that were tested under one of them.
std::vector<LoadQuality> bounds_of_tests(const StageResult& result);

}  // namespace breccia
