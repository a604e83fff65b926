#include "breccia/results/history_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/report_data.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::Lt;

/// A million samples of a wave that begins before time zero.
StoredHistory wave() {
  StoredHistory history;
  for (int i = -1000; i < 1000000; ++i) {
    const double time = 1e-6 * i;
    history.times.push_back(time);
    history.values.push_back(std::sin(2.0 * std::numbers::pi * 5000.0 * time));
  }
  return history;
}

TEST(OutlineOfHistory, KeepsTheExtremesOfRinging) {
  const auto history = wave();
  const auto outline = outline_of(history);
  EXPECT_THAT(outline.times.size(), Lt(2000U));
  EXPECT_EQ(outline.times.size(), outline.values.size());
  EXPECT_TRUE(std::ranges::is_sorted(outline.times));
  for (double begin = 0.0; begin < 0.99; begin += 0.01) {
    double least = 0.0, most = 0.0;
    for (std::size_t i = 0; i < outline.times.size(); ++i) {
      if (outline.times[i] < begin || outline.times[i] > begin + 0.01) continue;
      least = std::min(least, outline.values[i]);
      most = std::max(most, outline.values[i]);
    }
    EXPECT_NEAR(least, -1.0, 1e-3) << begin;
    EXPECT_NEAR(most, 1.0, 1e-3) << begin;
  }
}

TEST(OutlineOfHistory, KeepsAShortHistoryWhole) {
  const StoredHistory history{.deck_hash = "h", .times = {-1.0, 0.0, 1.0, 2.0}, .values = {0.0, 1.0, 3.0, 2.0}};
  const auto outline = outline_of(history);
  EXPECT_EQ(outline.times, history.times);
  EXPECT_EQ(outline.values, history.values);
  EXPECT_EQ(outline.deck_hash, "h");
  EXPECT_TRUE(outline_of(StoredHistory{}).times.empty());
}

TEST(RoundedNumbers, HaveSixDigits) {
  EXPECT_THAT(rounded({0.0, 1.23456789, -98765.4321, 1e-300, INFINITY}),
              ElementsAre(0.0, 1.23457, -98765.4, 1e-300, INFINITY));
}

}  // namespace
}  // namespace breccia
