#pragma once

namespace breccia {

/// When the greedy selection of snapshots ends.
struct SamplingOptions {
  double tolerance = 1e-5;  ///< of the relative error of the modulus at the next snapshot before it is added [-]
  int most_snapshots = 24;
};

}  // namespace breccia
