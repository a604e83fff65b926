#pragma once

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// A stretch of time [s] with 0 < begin <= end.
struct TimeWindow {
  double begin = 0.0;
  double end = 0.0;

  friend bool operator==(const TimeWindow&, const TimeWindow&) = default;
};

/// A Prony series with the terms that matter in a window.
struct ReducedSeries {
  PronySeries series;
  double error_bound = 0.0;  ///< on the relative error of the modulus in the window [-]
};

/// Terms much slower than the window become springs, terms much faster are dropped, as long as the error stays below
/// `tolerance` (theory, Eqs. 8 and 9): a slow term relaxes by at most M_k t1/tau_k within the window; a fast one
/// contributes at most M_k exp(-t0/tau_k) to the modulus and to leading order, acts on a field that still changes at
/// the rate 1/t like a dashpot, with M_k tau_k/t0.
ReducedSeries reduce_to_window(const PronySeries& series, const TimeWindow& window, double tolerance);

}  // namespace breccia
