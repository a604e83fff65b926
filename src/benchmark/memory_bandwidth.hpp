#pragma once

#include <cstddef>
#include <memory>

#include "benchmark/clock.hpp"

namespace breccia {

/// Memory bandwidth, with the bytes counted as in the STREAM benchmark (McCalpin 1995): every array once for each time
/// that the statement reads or writes it.
struct MemoryBandwidth {
  double triad = 0.0;   ///< bandwidth of a = b + s c [B/s]
  double update = 0.0;  ///< bandwidth of a = a + s b, which updates an array in place as an explicit step does [B/s]
};

/// Arrays larger than the caches, on which the bandwidth is measured.
class MemoryStreams {
 public:
  explicit MemoryStreams(int threads);

  /// Measures for about `seconds`. On several processes, which must all call it, returns the sum over them.
  [[nodiscard]] MemoryBandwidth measure(double seconds, Clock clock);

 private:
  static constexpr std::size_t length = 8'000'000;
  using Array = std::unique_ptr<double[]>;  // NOLINT(modernize-avoid-c-arrays): not initialised by one thread for all

  int threads_;
  Array a_, b_, c_;
};

}  // namespace breccia
