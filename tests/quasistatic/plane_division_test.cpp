#include "quasistatic/operator/plane_division.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

TEST(PlaneDivision, GivesEveryPlaneToOneProcess) {
  for (const int planes : {1, 2, 7, 10, 97, 513}) {
    for (int processes = 1; processes <= std::min(planes, 70); ++processes) {
      const auto division = PlaneDivision::among(processes, planes);
      ASSERT_TRUE(division);
      std::vector<int> given;
      given.reserve(static_cast<std::size_t>(processes));
      for (int process = 0; process < processes; ++process) given.push_back(division->planes(process));
      const auto [fewest, most] = std::ranges::minmax(given);
      EXPECT_GE(fewest, 1);
      EXPECT_LE(most - fewest, 1);
      EXPECT_EQ(division->first(0), 0);
      EXPECT_EQ(division->first(processes), planes);
    }
  }
}

TEST(PlaneDivision, HasNothingForMoreProcessesThanPlanes) {
  EXPECT_FALSE(PlaneDivision::among(3, 2));
}

}  // namespace
}  // namespace breccia::quasistatic
