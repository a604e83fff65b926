#pragma once

#include <functional>
#include <span>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/progress.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"

namespace breccia {

class Checkpoint;

/// Response of a composite to one load, stepped through time.
struct SteppedResponse {
  Load load = Load::shear;
  double unrelaxed = 0.0;  ///< value right after the load is applied
  /// Relaxation modulus [Pa] under a displacement or periodic boundary, creep compliance [1/Pa] under a traction
  /// boundary, at the requested times.
  std::vector<double> values;
  /// Estimate of the relative error of each value from the finite time steps [-].
  std::vector<double> error_estimates;
};

template <int dim>
struct SteppingResult {
  std::vector<SteppedResponse> responses;  ///< responses by load
  /// Fields of the points of a square, or of the cells of a cube, under the first load. They are on the first process,
  /// and zero on the other processes.
  std::vector<TimedFields<dim>> fields;
  LinearEffort effort;
};

/// Applies each load as a step at time 0 and integrates the response over the times given [s], which are positive and
/// rising; the displacements are linear in time between them (theory, Eq. 17). The materials are integrated exactly;
/// the error of second order in the time steps is estimated from a second run over every other time. Any of the
/// materials may relax. Fields are kept at those of the times that are in `field_times`. With a checkpoint, the state
/// is saved between steps when that is due, and an earlier state is resumed, with results that are bitwise identical to
/// those of one run. Throws InputError when the problem is incomplete, NumericalError when a linear system cannot be
/// solved. Instantiated for 2 and 3 dimensions.
template <int dim>
SteppingResult<dim> run_log_time_stepping(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                          std::span<const double> times, const ProgressObserver& observer = {},
                                          std::span<const double> field_times = {}, Checkpoint* checkpoint = nullptr);

}  // namespace breccia
