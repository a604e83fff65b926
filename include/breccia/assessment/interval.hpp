#pragma once

namespace breccia {

/// The ends of an interval.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

}  // namespace breccia
