#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/observation.hpp"

namespace breccia {

/// A time or a frequency between two of a curve: their indices, and the share of the second on a logarithmic axis.
struct Between {
  Eigen::Index first, second;
  double share;
};

/// Where a time or a frequency lies among those of a curve; beyond the ends of the curve, at these.
Between between(const std::vector<double>& at, double place);

/// The value of each curve at its times or frequencies, by curve: the logarithm of a modulus, a phase as it is.
using CurveValues = std::vector<Eigen::VectorXd>;

/// The values of curves in a sample.
CurveValues values_of_sample(const std::vector<SampledCurve>& curves, Eigen::Index sample);

/// The value of a curve at a time or a frequency, from its values (CurveValues): interpolated on double logarithmic
/// axes, a phase on one logarithmic axis.
double interpolated(const SampledCurve& curve, const Eigen::VectorXd& values, double at);

/// The curve of a modulus among these; null where they have none.
const SampledCurve* curve_of(const std::vector<SampledCurve>& curves, ObservedModulus modulus, ObservedCurve curve);

/// G, or K where the load bulk was tested: with its imaginary part over frequency. `values` are those of the curves.
std::complex<double> modulus_at(const std::vector<SampledCurve>& curves, const CurveValues& values,
                                ObservedModulus modulus, double at);

/// The value that an observation would have, in its unit, where the curves have these values. The curves must have what
/// was observed (require_observable).
double observed_value(const std::vector<SampledCurve>& curves, const CurveValues& values,
                      const Observation& observation);

}  // namespace breccia
