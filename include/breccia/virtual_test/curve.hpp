#pragma once

#include <span>
#include <vector>

#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// A modulus at a time.
struct Sample {
  double time = 0.0;     ///< [s]
  double modulus = 0.0;  ///< [Pa]

  friend bool operator==(const Sample&, const Sample&) = default;
};

/// Modulus against time, times rising.
using Curve = std::vector<Sample>;

/// A creep compliance at a time.
struct CreepSample {
  double time = 0.0;        ///< [s]
  double compliance = 0.0;  ///< [1/Pa]

  friend bool operator==(const CreepSample&, const CreepSample&) = default;
};

/// Creep compliance against time, times rising.
using Creep = std::vector<CreepSample>;

/// The first and the last time of a window, and between them the times 10^(k / per_decade) s for whole k. Throws
/// InputError for less than one time a decade.
std::vector<double> logarithmic_times(const TimeWindow& window, int per_decade);

/// Modulus [Pa] of a densely sampled curve at a time [s]: a least-squares parabola in ln t through the samples within a
/// fortieth of a decade of it. Ringing with shorter periods averages out; the bias is of fourth order in the width.
/// With fewer than five samples that close, the value is interpolated linearly in ln t. Throws InputError outside the
/// curve.
double smoothed_at(std::span<const Sample> curve, double time);

}  // namespace breccia
