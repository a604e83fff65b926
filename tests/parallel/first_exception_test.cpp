#include "parallel/first_exception.hpp"

#include <atomic>
#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

namespace breccia::parallel {
namespace {

TEST(FirstException, LeavesTheRegionOfItsThreads) {
  FirstException failure;
#pragma omp parallel for num_threads(2)
  for (int i = 0; i < 100; ++i) {
    failure.run([&] {
      if (i == 17) throw std::bad_alloc();
    });
  }
  EXPECT_THROW(failure.rethrow(), std::bad_alloc);
}

TEST(FirstException, IsTheFirst) {
  FirstException failure;
  failure.run([] { throw std::bad_alloc(); });
  bool is_run = false;
  failure.run([&] {
    is_run = true;
    throw std::runtime_error("the second");
  });
  EXPECT_FALSE(is_run);
  EXPECT_THROW(failure.rethrow(), std::bad_alloc);
}

TEST(FirstException, IsNoneWhereAllWorkIsDone) {
  FirstException failure;
  std::atomic<int> done = 0;
#pragma omp parallel for num_threads(2)
  for (int i = 0; i < 100; ++i) failure.run([&] { ++done; });
  EXPECT_NO_THROW(failure.rethrow());
  EXPECT_EQ(done, 100);
}

}  // namespace
}  // namespace breccia::parallel
