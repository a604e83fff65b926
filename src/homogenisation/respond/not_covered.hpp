#pragma once

#include <optional>
#include <string>

#include "breccia/error.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Error: the matrix leaves the range of moduli over which the reduced responses of a stage were sampled.
class NotCovered : public InputError {
 public:
  NotCovered(const std::string& message, std::optional<TimeWindow> times, Abscissa abscissa = Abscissa::time)
      : InputError(message), times_(times), abscissa_(abscissa) {}
  /// The part of the requested times that all responses cover, rounded inwards to two digits [s].
  [[nodiscard]] const std::optional<TimeWindow>& times() const noexcept { return times_; }
  /// The abscissa of the results that were asked for.
  [[nodiscard]] Abscissa abscissa() const noexcept { return abscissa_; }

 private:
  std::optional<TimeWindow> times_;
  Abscissa abscissa_;
};

}  // namespace breccia
