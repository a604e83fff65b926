#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/observation.hpp"

namespace breccia {

/// A curve of several composites: at the times or frequencies of the first that all have, and at the ends of what all
/// have.
struct ComparedCurve {
  std::string name = {};                             ///< "G", "K + G/3", "|G*|", "phase of G*"
  std::string unit = {};                             ///< "Pa", or "rad" of a phase
  ObservedModulus modulus = ObservedModulus::shear;  ///< G or K
  double share_of_shear = 0.0;                       ///< share of G in it beside K: 1/3 of K + G/3
  ObservedCurve curve = ObservedCurve::relaxation;
  std::vector<double> at = {};  ///< rising times [s], or angular frequencies [rad/s]
  Eigen::MatrixXd values = {};  ///< at x composites
  /// The errors of moduli by grid, sample and solver, over them [-], by composite and place; nothing where one is not
  /// known, and of a phase.
  std::vector<std::vector<std::optional<double>>> errors = {};
};

/// How a composite differs from the first at a place of a curve.
struct CurveDifference {
  double value = 1.0;  ///< the ratio of moduli, or the difference of phases [rad]
  /// What the errors of both make of a ratio [-], as if they were independent; nothing where one is not known.
  std::optional<double> error = {};

  /// Whether a ratio differs from 1 by more than its error.
  [[nodiscard]] bool is_beyond_error() const;
};

/// Curves of several composites, and the names of those that not all of them have.
struct ComparedCurves {
  std::vector<ComparedCurve> curves = {};
  std::vector<std::string> left_out = {};
};

/// The curves of several composites, one sample each (curves_of), beside each other. Throws InputError where they have
/// no curve, or no time of it, in common.
ComparedCurves compare_curves(const std::vector<std::vector<SampledCurve>>& composites);

CurveDifference difference_from_first(const ComparedCurve& curve, std::size_t composite, std::size_t place);

/// Measured values as they are compared: storage and loss modulus at a frequency as one absolute value. Throws
/// InputError, with a line for each mistake, for values of another kind than these curves, of one sample each, have.
std::vector<Observation> comparable_values(const std::vector<Observation>& measured,
                                           const std::vector<SampledCurve>& curves);

/// The measured values at the times or frequencies of a compared curve.
std::vector<Observation> values_within(const std::vector<Observation>& measured, const ComparedCurve& compared);

/// How far computed moduli are from measured ones.
struct MeasuredDeviation {
  std::size_t count = 0;           ///< number of measured values
  double rms = 0.0;                ///< root of the mean square of the logarithms of the ratios computed / measured
  double least = 1.0, most = 1.0;  ///< ratios computed / measured
  double at_least = 0.0, at_most = 0.0;  ///< their times [s] or angular frequencies [rad/s]
};

/// The deviation of a composite, from its curves of one sample each, from comparable values within these curves. There
/// must be one at least.
MeasuredDeviation deviation_from(const std::vector<Observation>& measured, const std::vector<SampledCurve>& curves);

}  // namespace breccia
