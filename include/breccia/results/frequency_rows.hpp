#pragma once

#include <optional>
#include <vector>

#include "breccia/study/tests.hpp"
#include "breccia/virtual_test/curve.hpp"

namespace breccia {

/// The frequencies of the dynamic moduli in the tables of a study.
struct FrequencyRows {
  /// So many a decade, at whole parts of decades in hertz, with the first and the last frequency of the curve; nothing:
  /// the angular frequencies 1/t of the times of the curve.
  std::optional<int> hertz_per_decade = {};

  /// In hertz, where a deck gives frequencies.
  static FrequencyRows of(const Tests& tests);
  /// The angular frequencies of a curve [rad/s], rising.
  [[nodiscard]] std::vector<double> of(const Curve& curve) const;
};

}  // namespace breccia
