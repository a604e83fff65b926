#pragma once

#include <atomic>

namespace breccia::dynamics {

/// Informs the processor that its thread waits in a loop, so that the other thread of the core gets more of it.
inline void pause_in_loop() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Number of steps that a thread has finished. Other threads can wait until it is large enough.
class StepCounter {
 public:
  void reset() noexcept { finished_.store(0, std::memory_order_relaxed); }

  void set(int steps) noexcept {
    // The store is sequentially consistent, because the check for sleeping threads that follows must not overtake it.
    finished_.store(steps, std::memory_order_seq_cst);
    finished_.notify_all();
  }

  /// Spins for longer than another program keeps a core at a time, since a thread that sleeps does not get its core
  /// back any sooner. ThreadThrottle makes long waits rare.
  void wait_for(int steps) const noexcept {
    constexpr int patience = 200'000;
    for (int tries = 0; tries < patience; ++tries) {
      if (finished_.load(std::memory_order_acquire) >= steps) return;
      pause_in_loop();
    }
    for (int finished = finished_; finished < steps; finished = finished_) finished_.wait(finished);
  }

 private:
  alignas(64) std::atomic<int> finished_{0};
};

}  // namespace breccia::dynamics
