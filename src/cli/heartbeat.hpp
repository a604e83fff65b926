#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace breccia::cli {

/// Calls a function at a steady interval from a thread of its own, until it is destroyed. The function must not throw.
class Heartbeat {
 public:
  Heartbeat(std::chrono::milliseconds interval, std::function<void()> beat);

 private:
  std::jthread thread_;
};

}  // namespace breccia::cli
