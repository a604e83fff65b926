#pragma once

#include <atomic>
#include <thread>

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
      return;
    }
    constexpr int patience = 4000;
    for (int tries = 0; round_.load(std::memory_order_acquire) == round; ++tries) {
      if (tries < patience) {
        __builtin_ia32_pause();
      } else {
        std::this_thread::yield();
      }
    }
  }

 private:
  alignas(64) std::atomic<int> arrived_{0};
  alignas(64) std::atomic<unsigned> round_{0};
};

}  // namespace breccia::dynamics
