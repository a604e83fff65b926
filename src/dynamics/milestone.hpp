#pragma once

#include <atomic>

namespace breccia::dynamics {

/// Tells the processor that its thread waits in a loop, so that the other thread of the core may have its share.
inline void pause_in_loop() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// How many steps a thread has come, for others to wait until it is far enough.
class Milestone {
 public:
  void reset() noexcept { reached_.store(0, std::memory_order_relaxed); }

  void reach(int steps) noexcept {
    // Not a mere release, which the look for sleepers that follows could overtake.
    reached_.store(steps, std::memory_order_seq_cst);
    reached_.notify_all();
  }

  /// Spins for longer than another program keeps a core at a time: a thread that sleeps gets its own back no sooner.
  /// Crew sees to it that this is rare.
  void wait_for(int steps) const noexcept {
    constexpr int patience = 200'000;
    for (int tries = 0; tries < patience; ++tries) {
      if (reached_.load(std::memory_order_acquire) >= steps) return;
      pause_in_loop();
    }
    for (int reached = reached_; reached < steps; reached = reached_) reached_.wait(reached);
  }

 private:
  alignas(64) std::atomic<int> reached_{0};
};

}  // namespace breccia::dynamics
