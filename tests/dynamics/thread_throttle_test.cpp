#include "dynamics/thread_throttle.hpp"

#include <gtest/gtest.h>

namespace breccia::dynamics {
namespace {

TEST(ThreadThrottle, TakesAllWhereEveryThreadHasACore) {
  EXPECT_EQ(best_number_of_threads({1.0}), 1);
  EXPECT_EQ(best_number_of_threads({0.99, 1.0, 0.98, 1.0}), 4);
}

TEST(ThreadThrottle, LeavesOutAThreadThatHasHalfACore) {
  // Two threads, half of the time, are no faster than one.
  EXPECT_EQ(best_number_of_threads({0.5, 1.0}), 1);
  EXPECT_EQ(best_number_of_threads({1.0, 1.0, 0.5, 1.0}), 3);
}

TEST(ThreadThrottle, TakesOneWhereNoThreadHasACore) {
  EXPECT_EQ(best_number_of_threads({0.5, 0.5, 0.5}), 1);
}

TEST(ThreadThrottle, ToleratesProgramsThatTakeLittle) {
  EXPECT_EQ(best_number_of_threads({0.9, 0.9}), 2);
}

TEST(ThreadThrottle, KnowsThatAThreadAloneHasMoreOfTheCores) {
  // Beside one busy program each of two threads has two thirds of a core, but a thread alone has a whole one.
  EXPECT_EQ(best_number_of_threads({2.0 / 3.0, 2.0 / 3.0}), 1);
  EXPECT_EQ(best_number_of_threads({0.0, 0.0}), 1);
}

/// A simulation of two threads at work: steps of so many seconds, during a share of which the threads have a core.
class ThrottleOfTwo {
 public:
  ThreadThrottle throttle{2};

  void work(int steps, double seconds_each, double share) {
    const double wall = steps * seconds_each;
    for (int thread = 0; thread < throttle.threads(); ++thread) {
      throttle.record(static_cast<std::size_t>(thread), {(1.0 - share) * wall, wall});
    }
    throttle.adjust(steps);
  }
};

TEST(ThreadThrottle, TriesAllThreadsAgain) {
  ThrottleOfTwo two;
  EXPECT_EQ(two.throttle.threads(), 2);
  two.work(10, 0.01, 0.1);
  EXPECT_EQ(two.throttle.threads(), 1);
  int pieces = 0;
  for (; two.throttle.threads() == 1 && pieces < 100; ++pieces) two.work(100, 1e-3, 1.0);
  EXPECT_GE(pieces, 10);  // all threads are tried again after at least a second of work
  EXPECT_EQ(two.throttle.threads(), 2);
  // One thread alone is faster now.
  for (int i = 0; i < 9; ++i) {
    two.work(100, 6e-4, 1.0);
    EXPECT_EQ(two.throttle.threads(), 2);
  }
}

TEST(ThreadThrottle, KeepsAllThreadsOnlyWhereThatIsFaster) {
  ThrottleOfTwo two;
  const auto until_all_take_part = [&two] {
    two.work(10, 0.01, 0.1);
    for (int i = 0; i < 100 && two.throttle.threads() == 1; ++i) two.work(100, 1e-3, 0.7);
    ASSERT_EQ(two.throttle.threads(), 2);
  };
  // The threads are not displaced, but slower than one of them for another reason.
  until_all_take_part();
  two.work(100, 2e-3, 1.0);
  EXPECT_EQ(two.throttle.threads(), 1);
  for (int i = 0; i < 100 && two.throttle.threads() == 1; ++i) two.work(100, 1e-3, 0.7);
  // The threads are displaced, but faster all the same.
  two.work(100, 6e-4, 0.6);
  EXPECT_EQ(two.throttle.threads(), 2);
}

TEST(ThreadThrottle, SpendsLittleOnTrials) {
  // Steps of two threads take a hundred times as long.
  ThrottleOfTwo two;
  double of_two = 0.0, of_one = 0.0;
  while (of_one < 1000.0) {
    if (two.throttle.threads() == 2) {
      of_two += 1.0;
      two.work(10, 0.1, 0.2);
    } else {
      of_one += 0.1;
      two.work(100, 1e-3, 0.6);
    }
  }
  EXPECT_GT(of_two, 0.0);
  EXPECT_LT(of_two, 0.06 * of_one);
}

TEST(ThreadThrottle, DoesNotDecideByAMoment) {
  ThrottleOfTwo two;
  two.work(1, 1e-3, 0.0);
  EXPECT_EQ(two.throttle.threads(), 2);
}

}  // namespace
}  // namespace breccia::dynamics
