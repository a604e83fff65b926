#pragma once

#include <atomic>

namespace breccia::dynamics {

/// Lets threads meet twice a step. It spins for as long as threads are usually apart, a few microseconds, and then
/// gives the core away, so that a machine with more threads than cores stays usable.
class Barrier {
 public:
  /// Returns when all of this many threads have called it.
  void wait(int threads) noexcept {
    const auto round = round_.load(std::memory_order_acquire);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads) {
      arrived_.store(0, std::memory_order_relaxed);
      round_.store(round + 1, std::memory_order_release);
      round_.notify_all();
      return;
    }
    constexpr int patience = 4000;
    for (int tries = 0; tries < patience; ++tries) {
      if (round_.load(std::memory_order_acquire) != round) return;
      __builtin_ia32_pause();
    }
    while (round_.load(std::memory_order_acquire) == round) round_.wait(round, std::memory_order_acquire);
  }

 private:
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<unsigned> round_{0};
};

}  // namespace breccia::dynamics
