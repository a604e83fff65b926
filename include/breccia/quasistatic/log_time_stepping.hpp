#pragma once

#include <functional>
#include <span>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/discretisation/point_fields.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

namespace breccia {

/// The answer of a composite to one load, stepped through time.
struct SteppedResponse {
  Load load = Load::shear;
  double unrelaxed = 0.0;  ///< value right after the load is applied
  /// Relaxation modulus [Pa] under a displacement or periodic boundary, creep compliance [1/Pa] under a traction one.
  std::vector<double> values;
  /// Estimate of the relative error of each value, by the steps in time [-].
  std::vector<double> error_estimates;
};

struct SteppingResult {
  std::vector<SteppedResponse> responses;  ///< by load
  std::vector<TimedFields> fields;         ///< of the first load; on the first process, on the others zero
  LinearEffort effort;
};

/// Told the share of the work that is done, 0 to 1. What it throws ends the work.
using ShareObserver = std::function<void(double)>;

/// Applies each load as a step at time 0, and follows it to the times given [s], rising and positive, with
/// displacements that are linear in time between them (theory, Eq. 17). Exact in the materials; of second order in the
/// steps, whose error is estimated from a second run over every other time. Any of the materials may relax. Fields are
/// kept at those of the times that are in `field_times`. With a checkpoint it leaves its state there between steps when
/// that is due, and goes on from what is there: the same bits as in one go.
/// Throws InputError when the problem is incomplete, NumericalError when a linear system cannot be solved.
SteppingResult run_log_time_stepping(const QuasistaticProblem& problem, std::span<const Load> loads,
                                     std::span<const double> times, const ShareObserver& observer = {},
                                     std::span<const double> field_times = {}, Checkpoint* checkpoint = nullptr);

}  // namespace breccia
