#pragma once

#include <ctime>

#include "benchmark/clock.hpp"

namespace breccia::benchmark {

/// Measures the time since its construction, of work on the given number of threads.
class StopWatch {
 public:
  StopWatch(Clock clock, int threads)
      : source_(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID),
        share_(clock == Clock::wall ? 1.0 : 1.0 / threads),
        start_(now()) {}

  [[nodiscard]] double seconds() const { return share_ * (now() - start_); }

 private:
  [[nodiscard]] double now() const {
    timespec time{};
    clock_gettime(source_, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t source_;
  double share_;
  double start_;
};

}  // namespace breccia::benchmark
