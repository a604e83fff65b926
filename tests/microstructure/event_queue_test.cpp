#include "microstructure/event_queue.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(EventQueue, FirstIsTheEarliestAfterEveryChange) {
  constexpr std::uint32_t balls = 37;
  EventQueue queue(balls);
  std::vector<double> times(balls, never);
  std::mt19937_64 engine(3);
  for (int change = 0; change < 5000; ++change) {
    const auto ball = static_cast<std::uint32_t>(engine() % balls);
    times[ball] = engine() % 10 == 0 ? never : static_cast<double>(engine() >> 11);
    queue.set(ball, times[ball]);
    ASSERT_EQ(times[queue.first()], std::ranges::min(times));
  }
}

}  // namespace
}  // namespace breccia
