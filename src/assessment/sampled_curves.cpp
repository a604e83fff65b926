#include "assessment/sampled_curves.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/assessment/stage_curves.hpp"
#include "breccia/error.hpp"

#include "assessment/curves_of_stage.hpp"
#include "parallel/first_exception.hpp"
#include "parallel/threads.hpp"

namespace breccia {
namespace {

/// Throws NumericalError where a modulus is not positive, as where a sample has all but relaxed.
void require_positive(const SampledCurve& curve) {
  if (curve.curve == ObservedCurve::phase) return;
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    if (curve.values.row(static_cast<Eigen::Index>(i)).minCoeff() > 0.0) continue;
    throw NumericalError(
        fmt::format("{} at {:.3g} {} is not positive in a sample, which has all but relaxed: end the times of the "
                    "tests earlier",
                    curve.name, curve.at[i], is_over_frequency(curve.curve) ? "rad/s" : "s"));
  }
}

}  // namespace

std::vector<SampledCurve> sample_curves(const SampledStage& stage) {
  const auto samples = stage.box_of.size();
  CurvesOfStage taken(stage.reference, kinds_of(stage.reference).front(), samples);
  std::vector<Responder> boxes;
  for (const auto& box : stage.boxes) boxes.push_back(box.chain_of(stage.reference.name));
  parallel::FirstException failure;
#pragma omp parallel for num_threads(parallel::threads_for(stage.threads)) schedule(dynamic)
  for (std::size_t sample = 0; sample < samples; ++sample) {
    failure.run([&] {
      const auto results = boxes[stage.box_of[sample]].with(stage.materials[sample]).respond();
      taken.take(sample, results.back().tests);
    });
  }
  failure.rethrow();
  auto curves = std::move(taken).curves();
  std::ranges::for_each(curves, require_positive);
  return curves;
}

}  // namespace breccia
