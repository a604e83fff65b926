#include "crew.hpp"

#include <algorithm>
#include <ctime>
#include <functional>
#include <utility>

namespace breccia::dynamics {
namespace {

double seconds_of(clockid_t clock) noexcept {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Crew::Time now() noexcept {
  return {seconds_of(CLOCK_THREAD_CPUTIME_ID), seconds_of(CLOCK_MONOTONIC)};
}

}  // namespace

Crew::Crew(int most_threads)
    : most_(most_threads), threads_(most_threads), times_(static_cast<std::size_t>(most_threads)) {}

void Crew::add(std::size_t thread, const Time& time) {
  times_[thread].processor += time.processor;
  times_[thread].wall += time.wall;
}

void Crew::judge() {
  constexpr double long_enough = 0.03;  // several turns of the programs on a core
  constexpr double try_again = 1.0;
  const double wall = times_.front().wall;
  if (wall < long_enough) return;
  std::vector<double> shares;
  for (const auto& time : times_) {
    if (time.wall > 0.0) shares.push_back(time.processor / time.wall);
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

ThreadWatch::ThreadWatch() noexcept : start_(now()) {}

Crew::Time ThreadWatch::time() const noexcept {
  const auto end = now();
  return {end.processor - start_.processor, end.wall - start_.wall};
}

}  // namespace breccia::dynamics
