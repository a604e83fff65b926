#pragma once

#include <optional>
#include <vector>

#include "breccia/study/tests.hpp"
#include "breccia/virtual_test/curve.hpp"

namespace breccia {

/// The frequencies of the dynamic moduli in the tables of a study.
struct FrequencyRows {
  /// Number n of frequencies a decade: at 10^(k/n) Hz for whole k, and at the first and the last frequency of the
  /// curve. If absent, the angular frequencies are 1/t for the times t of the curve.
  std::optional<int> hertz_per_decade = {};

  /// The frequencies for the tests of a study: in hertz where its deck gives frequencies.
  static FrequencyRows of(const Tests& tests);
  /// The angular frequencies of a curve [rad/s], rising.
  [[nodiscard]] std::vector<double> of(const Curve& curve) const;
};

}  // namespace breccia
