#include "crew.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <utility>

namespace breccia::dynamics {
namespace {

/// As Linux counts it for the calling thread; 0 where it does not.
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

Crew::Crew(int most_threads)
    : most_(most_threads), threads_(most_threads), times_(static_cast<std::size_t>(most_threads)) {}

void Crew::add(std::size_t thread, const Time& time) {
  times_[thread].displaced += time.displaced;
  times_[thread].wall += time.wall;
}

void Crew::judge() {
  constexpr double long_enough = 0.03;  // several turns of the programs on a core
  constexpr double try_again = 1.0;
  const double wall = times_.front().wall;
  if (wall < long_enough) return;
  std::vector<double> shares;
  for (const auto& time : times_) {
    if (time.wall > 0.0) shares.push_back(std::max(0.0, 1.0 - time.displaced / time.wall));
  }
  short_for_ = threads_ < most_ ? short_for_ + wall : 0.0;
  threads_ = best_number_of_threads(std::move(shares));
  if (short_for_ > try_again) {
    threads_ = most_;
    short_for_ = 0.0;
  }
  std::ranges::fill(times_, Time{});
}

int best_number_of_threads(std::vector<double> shares) {
  constexpr double worth_it = 1.02;
  std::ranges::sort(shares, std::greater{});
  int best = 1;
  double together = 1.0, most = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const int threads = static_cast<int>(i) + 1;
    together *= shares[i];
    if (threads * together > worth_it * most) {
      best = threads;
      most = threads * together;
    }
  }
  return best;
}

ThreadWatch::ThreadWatch() : start_{seconds_displaced(), seconds_now()} {}

Crew::Time ThreadWatch::time() const {
  return {seconds_displaced() - start_.displaced, seconds_now() - start_.wall};
}

}  // namespace breccia::dynamics
