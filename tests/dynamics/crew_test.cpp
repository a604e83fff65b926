#include "crew.hpp"

#include <gtest/gtest.h>

namespace breccia::dynamics {
namespace {

TEST(Crew, IsWholeWhereEveryThreadHasACore) {
  EXPECT_EQ(best_number_of_threads({1.0}), 1);
  EXPECT_EQ(best_number_of_threads({0.99, 1.0, 0.98, 1.0}), 4);
}

TEST(Crew, LeavesOutAThreadThatHasHalfACore) {
  // Two threads, half of the time, are no faster than one.
  EXPECT_EQ(best_number_of_threads({0.5, 1.0}), 1);
  EXPECT_EQ(best_number_of_threads({1.0, 1.0, 0.5, 1.0}), 3);
}

TEST(Crew, IsOneWhereNoThreadHasACore) {
  EXPECT_EQ(best_number_of_threads({0.5, 0.5, 0.5}), 1);
}

TEST(Crew, BearsProgramsThatTakeLittle) {
  EXPECT_EQ(best_number_of_threads({0.9, 0.9}), 2);
}

TEST(Crew, IsTriedAgainAsAWhole) {
  Crew crew(4);
  EXPECT_EQ(crew.threads(), 4);
  const auto work_with_shares = [&](double of_first, double of_others) {
    for (int thread = 0; thread < crew.threads(); ++thread) {
      crew.add(static_cast<std::size_t>(thread), {0.1 * (1.0 - (thread == 0 ? of_first : of_others)), 0.1});
    }
    crew.judge();
  };
  work_with_shares(1.0, 0.1);
  EXPECT_EQ(crew.threads(), 1);
  for (int i = 0; i < 9; ++i) {
    work_with_shares(1.0, 1.0);
    EXPECT_EQ(crew.threads(), 1);
  }
  for (int i = 0; i < 3; ++i) work_with_shares(1.0, 1.0);
  EXPECT_EQ(crew.threads(), 4);
}

TEST(Crew, DoesNotJudgeByAMoment) {
  Crew crew(2);
  crew.add(0, {0.0, 1e-3});
  crew.add(1, {1e-3, 1e-3});
  crew.judge();
  EXPECT_EQ(crew.threads(), 2);
}

}  // namespace
}  // namespace breccia::dynamics
