#pragma once

#include <functional>
#include <span>
#include <vector>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/discretisation/point_fields.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia {

/// When a reduced response is good enough.
struct SamplingOptions {
  double tolerance = 1e-5;  ///< relative error of the modulus at the last snapshot before it was added [-]
  int most_snapshots = 24;
};

/// How far sampling is.
struct SamplingProgress {
  int snapshots = 0;
  double error = 1.0;  ///< relative, at the last snapshot before it was added; 1 before any was measured [-]
};

struct SampledResponses {
  /// Fields of the points at a time [s] after one of the loads, by its place, was applied to the composite with a
  /// viscoelastic matrix; per unit of the load (theory, Eqs. 34 and 35). On the first process; on the others zero.
  using Recovery = std::function<PointFields(std::size_t load, const Material& matrix, double time)>;

  std::vector<ReducedResponse> responses;  ///< by load
  LinearEffort effort;
  Recovery fields;  ///< it keeps the solutions
};

/// Solves for matrix moduli [Pa] chosen from `path` until the reduced responses meet the tolerance: first both ends and
/// the middle, then where an estimate expects the largest error, which is measured there before the solution is added.
/// With a checkpoint it leaves its state there between solutions when that is due, and goes on from what is there: the
/// same bits as in one go. The moduli of the matrix in the problem are not used; all other materials must be elastic.
/// Throws InputError when they are not, NumericalError when a system cannot be solved or the tolerance not be met.
SampledResponses sample_responses(const QuasistaticProblem& problem, MaterialIndex matrix, std::span<const Load> loads,
                                  std::span<const Moduli> path, const SamplingOptions& options = {},
                                  const std::function<void(const SamplingProgress&)>& observer = {},
                                  Checkpoint* checkpoint = nullptr);

}  // namespace breccia
