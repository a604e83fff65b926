#pragma once

#include <cstddef>
#include <memory>

#include "breccia/benchmark/clock.hpp"

namespace breccia {

/// What the memory moves where next to nothing is computed, counted as STREAM does (McCalpin 1995): every array once
/// for each time that the statement reads or writes it [B/s].
struct MemoryBandwidth {
  double triad = 0.0;   ///< a = b + s c
  double update = 0.0;  ///< a = a + s b: what is written has been read, as in an explicit step
};

/// Arrays larger than the caches, on which the bandwidth is measured.
class MemoryStreams {
 public:
  explicit MemoryStreams(int threads);

  /// Goes over the arrays for about so long [s]. Of several processes, which all measure at a time, the sum.
  [[nodiscard]] MemoryBandwidth measure(double seconds, Clock clock);

 private:
  static constexpr std::size_t length = 8'000'000;
  using Array = std::unique_ptr<double[]>;  // NOLINT(modernize-avoid-c-arrays): not initialised by one thread for all

  int threads_;
  Array a_, b_, c_;
};

}  // namespace breccia
