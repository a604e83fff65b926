#pragma once

namespace breccia {

/// Criteria by which the greedy selection of snapshots ends.
struct SamplingOptions {
  /// Tolerance of the relative error of the modulus at the next snapshot before it is added [-].
  double tolerance = 1e-5;
  int most_snapshots = 24;
};

}  // namespace breccia
