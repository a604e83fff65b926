#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Limits of a reduction by reduce_prony().
struct PronyReductionOptions {
  double tolerance = 0.01;  ///< largest relative deviation wanted [-]
  /// Largest number of different relaxation times of all series.
  std::size_t most_terms = std::numeric_limits<std::size_t>::max();
};

/// Series that replace others in a window of time. They have few relaxation times, which all of them share.
struct PronyReduction {
  std::vector<PronySeries> series;
  std::vector<double> deviations;  ///< largest relative deviation of each series in the window [-]

  /// The number of different relaxation times of all series.
  [[nodiscard]] std::size_t relaxation_times() const;
  [[nodiscard]] double worst_deviation() const;
};

/// Replaces series, some of whose terms may be negative (PronySeries::difference), by series without negative terms
/// that follow them in a window of time: with the fewest common relaxation times found for which all series deviate by
/// at most the tolerance, which is checked at 40 times a decade (theory, Eq. 33b). A wider tolerance hardly ever takes
/// more times. A modulus that changes by at most half of the tolerance in the window becomes elastic. Series without
/// negative terms are returned unchanged where no shorter ones are found. Where the tolerance is not met with the terms
/// allowed, the series whose deviations exceed it least are returned; see worst_deviation(). Throws InputError for a
/// window of no length, a tolerance that is not positive, and a modulus that is not positive in the window.
PronyReduction reduce_prony(std::span<const PronySeries> series, const TimeWindow& window,
                            const PronyReductionOptions& options = {});

}  // namespace breccia
