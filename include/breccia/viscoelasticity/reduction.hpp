#pragma once

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// An interval of time [s] with 0 < begin <= end.
struct TimeWindow {
  double begin = 0.0;
  double end = 0.0;

  friend bool operator==(const TimeWindow&, const TimeWindow&) = default;
};

/// A Prony series reduced to the terms that matter in a time window.
struct ReducedSeries {
  PronySeries series;
  double error_bound = 0.0;  ///< bound on the relative error of the modulus in the window [-]
};

/// Reduces a series to a time window t0 to t1: terms much slower than the window become springs, terms much faster are
/// dropped, as many as keep the relative error below `tolerance` [-] (theory, Eqs. 8 and 9). A slow term relaxes by at
/// most M_k t1/tau_k within the window. A fast term contributes at most M_k exp(-t0/tau_k) to the modulus; on a field
/// that still changes at the rate 1/t it acts, to leading order, like a dashpot, which contributes M_k tau_k/t0.
ReducedSeries reduce_to_window(const PronySeries& series, const TimeWindow& window, double tolerance);

}  // namespace breccia
