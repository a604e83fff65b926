#pragma once

#include <functional>
#include <span>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia {

class Checkpoint;

/// When the greedy selection of snapshots ends.
struct SamplingOptions {
  double tolerance = 1e-5;  ///< of the relative error of the modulus at the next snapshot before it is added [-]
  int most_snapshots = 24;
};

/// Progress of the greedy selection.
struct SamplingProgress {
  int snapshots = 0;
  double error = 1.0;  ///< relative error at the last snapshot before it was added; 1 before one was measured [-]
};

struct SampledResponses {
  /// Fields of the points per unit load at a time [s] after a load was applied to the composite with a viscoelastic
  /// matrix (theory, Eqs. 34 and 35). `load` is the index in the list of loads. On the first process; zero on the
  /// others.
  using Recovery = std::function<PointFields<2>(std::size_t load, const Material& matrix, double time)>;

  std::vector<ReducedResponse> responses;  ///< by load
  LinearEffort effort;
  Recovery fields;  ///< owns the vectors of the basis
};

/// Builds a reduced response for each load from snapshots: elastic solutions for moduli of the matrix [Pa] taken from a
/// training set, which is ordered from stiff to soft. The initial snapshots are its middle and both ends; then a greedy
/// selection adds a snapshot where the error estimate is largest and measures the error there, until the tolerance is
/// met. The moduli of the matrix in the problem are not used; all other materials must be elastic. With a checkpoint,
/// the state is saved between solutions when that is due, and an earlier state is resumed, with the same bits as in one
/// run.
/// Throws InputError when there are no loads, a point has no material or another material relaxes, NumericalError when
/// a system cannot be solved or the tolerance cannot be met.
SampledResponses sample_responses(const QuasistaticProblem& problem, PhaseIndex matrix, std::span<const Load> loads,
                                  std::span<const Moduli> training_set, const SamplingOptions& options = {},
                                  const std::function<void(const SamplingProgress&)>& observer = {},
                                  Checkpoint* checkpoint = nullptr);

}  // namespace breccia
