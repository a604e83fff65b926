#include "cli/heartbeat.hpp"

#include <condition_variable>
#include <csignal>
#include <mutex>
#include <stop_token>
#include <utility>

namespace breccia::cli {
namespace {

/// During its lifetime new threads are started with all signals blocked, so that other threads handle them.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;
  BlockedSignals(BlockedSignals&&) = delete;
  BlockedSignals& operator=(BlockedSignals&&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

Heartbeat::Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat) {
  const BlockedSignals blocked;
  thread_ = std::jthread([interval, beat = std::move(beat)](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any pause;
    std::unique_lock lock(mutex);
    while (true) {
      pause.wait_for(lock, stop, interval, [] { return false; });
      if (stop.stop_requested()) return;
      beat();
    }
  });
}

}  // namespace breccia::cli
