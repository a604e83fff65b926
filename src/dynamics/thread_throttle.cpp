#include "dynamics/thread_throttle.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

namespace breccia::dynamics {
namespace {

/// More threads are used only if they are faster by this factor.
constexpr double least_gain = 1.02;

/// Time that the calling thread was ready to run while its core was taken [s], as Linux counts it; 0 on other systems.
double seconds_displaced() {
  std::ifstream file("/proc/thread-self/schedstat");
  double running = 0.0, displaced = 0.0;
  file >> running >> displaced;
  return 1e-9 * displaced;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ThreadThrottle::ThreadThrottle(int most_threads)
    : most_(most_threads), threads_(most_threads), times_(static_cast<std::size_t>(most_threads)) {}

void ThreadThrottle::record(std::size_t thread, const Time& time) {
  times_[thread].displaced += time.displaced;
  times_[thread].wall += time.wall;
}

void ThreadThrottle::adjust(int steps) {
  constexpr double long_enough = 0.03;  // time [s] of several time slices of the programs on a core
  steps_ += steps;
  const double wall = times_.front().wall;
  if (wall < long_enough) return;
  if (threads_ == most_) {
    adjust_after_all(steps_ / wall, wall);
  } else {
    adjust_after_some(wall);
  }
  steps_ = 0.0;
  std::ranges::fill(times_, Time{});
}

void ThreadThrottle::adjust_after_all(double speed, double wall) {
  if (some_steps_ > 0.0) {
    const bool is_faster = speed * some_wall_ > least_gain * some_steps_;
    if (!is_faster) leave_out(some_threads_, wall);
    some_steps_ = some_wall_ = 0.0;
    return;
  }
  std::vector<double> shares;
  shares.reserve(times_.size());
  for (const auto& time : times_) shares.push_back(1.0 - time.displaced / std::max(time.wall, time.displaced + 1e-9));
  const int best = best_number_of_threads(shares);
  if (best < most_) leave_out(best, wall);
}

void ThreadThrottle::adjust_after_some(double wall) {
  some_steps_ += steps_;
  some_wall_ += wall;
  rest_ -= wall;
  if (rest_ <= 0.0) threads_ = most_;
}

/// Limits the work to some threads, after all threads have worked for a time [s] and were no faster.
void ThreadThrottle::leave_out(int threads, double wall) {
  constexpr double shortest = 1.0, times_the_trial = 20.0;
  threads_ = some_threads_ = threads;
  rest_ = std::max(shortest, times_the_trial * wall);
}

int best_number_of_threads(const std::vector<double>& shares) {
  constexpr double least = 1e-3;
  const auto cores = static_cast<double>(shares.size());
  // A core that a thread has for the share s runs 1/s - 1 other programs beside it.
  double programs = 0.0, all = cores;
  for (const double share : shares) {
    programs += 1.0 / std::max(share, least) - 1.0;
    all *= share;
  }
  int best = 1;
  double most = 0.0;
  for (int threads = 1; threads <= static_cast<int>(shares.size()); ++threads) {
    const double share = std::min(1.0, cores / (programs + threads));
    const double done = threads == static_cast<int>(shares.size()) ? all : threads * std::pow(share, threads);
    if (done > least_gain * most) {
      best = threads;
      most = done;
    }
  }
  return best;
}

ThreadWatch::ThreadWatch() : start_{seconds_displaced(), seconds_now()} {}

ThreadThrottle::Time ThreadWatch::time() const {
  return {seconds_displaced() - start_.displaced, wall()};
}

double ThreadWatch::wall() const {
  return seconds_now() - start_.wall;
}

}  // namespace breccia::dynamics
