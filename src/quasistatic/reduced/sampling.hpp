#pragma once

#include <functional>
#include <span>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/progress.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/quasistatic/sampling_options.hpp"

#include "quasistatic/reduced/training_path.hpp"

namespace breccia {

class Checkpoint;

template <int dim>
struct SampledResponses {
  /// Fields of the points of a square, or of the cells of a cube, per unit load at a time [s] after a load was applied
  /// to the composite with these materials as its varying phases, in the order of the phases (theory, Eqs. 34 and 35).
  /// `load` is the index in the list of loads. The fields are on the first process; they are zero on the other
  /// processes.
  using Recovery =
      std::function<LatticeFields<dim>(std::size_t load, std::span<const Material> of_phases, double time)>;

  std::vector<ReducedResponse> responses;  ///< responses by load
  LinearEffort effort;
  Recovery fields;  ///< function that computes fields; it owns the vectors of the basis
};

/// Builds a reduced response for each load from snapshots: elastic solutions for moduli [Pa] taken from a training set.
/// The initial snapshots are its middle and both ends; then a greedy selection adds a snapshot where the error estimate
/// is largest and measures the error there, until the tolerance is met and, with a target curve, the curve in time no
/// longer changes, or as many snapshots are taken as are allowed: the estimates of the responses then tell the error
/// that is left. The materials of the phases that vary are not used; all others must be elastic. With a checkpoint, the
/// state is saved between solutions when that is due, and an earlier state is resumed, with results that are bitwise
/// identical to those of one run. Throws InputError when there are no loads, a point has no material, the training set
/// is empty, has a point without the moduli of each of its phases or names a phase twice or one without material, or
/// another material relaxes; NumericalError when a system cannot be solved or the error that is left is above a tenth.
/// Instantiated for 2 and 3 dimensions.
template <int dim>
SampledResponses<dim> sample_responses(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                       const TrainingPath& training_set, const SamplingOptions& options = {},
                                       const ProgressObserver& observer = {}, Checkpoint* checkpoint = nullptr);

}  // namespace breccia
