#pragma once

#include <functional>
#include <optional>
#include <string>

#include "breccia/error.hpp"
#include "breccia/homogenisation/respond.hpp"

namespace breccia {

/// The matrix that lies between the particles under a boundary.
using MatrixUnder = std::function<const Material&(Boundary)>;

/// A matrix that leaves the range over which the responses of a stage were sampled.
class NotCovered : public InputError {
 public:
  NotCovered(const std::string& message, std::optional<TimeWindow> times) : InputError(message), times_(times) {}
  /// The part of the times asked for that all responses cover, rounded inwards to two digits [s].
  [[nodiscard]] const std::optional<TimeWindow>& times() const noexcept { return times_; }

 private:
  std::optional<TimeWindow> times_;
};

/// Throws NotCovered where a response of a stage does not cover a window with its matrix.
void require_coverage(const StoredResponses& stored, const MatrixUnder& matrix, const TimeWindow& window);

/// The message of a refusal with the times that can be asked for in its place, if there are any.
std::string with_covered_times(const NotCovered& refusal, const std::optional<TimeWindow>& times);

/// What an attempt gives over a window. Where that is not covered, a narrower one is looked for in which the whole
/// attempt succeeds, and InputError tells of it.
template <class Attempt>
auto or_tell_covered_times(const TimeWindow& window, const Attempt& attempt) -> decltype(attempt(window)) {
  try {
    return attempt(window);
  } catch (const NotCovered& refusal) {
    auto left = refusal.times();
    // A later stage may cover less than an earlier one: each round is narrower than the one before.
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
    throw InputError(with_covered_times(refusal, left));
  }
}

}  // namespace breccia
