#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_responses.hpp"

#include "homogenisation/respond/not_covered.hpp"

namespace breccia {

/// The matrix of a stage for each boundary.
using MatrixUnder = std::function<const Material&(Boundary)>;

/// The materials of the varying phases of a reduced response, in the order of the phases: this matrix, and the
/// materials of the other phases of the stage. Throws InputError where one is missing.
std::vector<Material> materials_for(const StageResponses& stage, const ReducedResponse& response,
                                    const Material& matrix);

/// Throws NotCovered if a reduced response of a stage does not cover a window of times [s] with its matrix.
void require_coverage(const StageResponses& stage, const MatrixUnder& matrix, const TimeWindow& window);

/// A refusal with the times, or the frequencies, that can be requested instead, if there are any.
NotCovered with_covered_times(const NotCovered& refusal, const std::optional<TimeWindow>& times, Abscissa abscissa);

/// Returns the result of a function of a window of times. If the function throws NotCovered, searches for a narrower
/// window in which it succeeds, and throws NotCovered with that window.
template <class Attempt>
auto or_refuse_with_covered_times(const TimeWindow& window, Abscissa abscissa, const Attempt& attempt)
    -> decltype(attempt(window)) {
  try {
    return attempt(window);
  } catch (const NotCovered& refusal) {
    auto left = refusal.times();
    // A later stage may cover less than an earlier one: the window becomes narrower in each iteration.
    for (bool is_covered = false; left && !is_covered;) {
      try {
        static_cast<void>(attempt(*left));
        is_covered = true;
      } catch (const NotCovered& narrower) {
        left = narrower.times();
      } catch (const NumericalError&) {
        left.reset();
      }
    }
    throw with_covered_times(refusal, left, abscissa);
  }
}

}  // namespace breccia
