#include "parallel/session.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "parallel/blas_threads.hpp"
#include "parallel/reduction.hpp"
#include "parallel/threads.hpp"

namespace breccia::parallel {
namespace {

TEST(Session, AProcessByItselfIsTheFirstOfOne) {
  start();
  start();
  EXPECT_EQ(rank(), 0);
  EXPECT_EQ(ranks(), 1);
}

TEST(Session, ErrorsOfPetscBecomeExceptions) {
  start();
  EXPECT_NO_THROW(check(0, "nothing"));
  EXPECT_THROW(check(73, "assembling"), NumericalError);
}

// With OMP_NUM_THREADS as many threads as it says, however small the work.
TEST(Threads, SmallWorkHasFewUnlessMoreAreAskedFor) {
  EXPECT_EQ(threads_for(3, 10, 100), 3);
  if (std::getenv("OMP_NUM_THREADS") != nullptr) GTEST_SKIP() << "OMP_NUM_THREADS is set";
  EXPECT_EQ(threads_for(0, 0, 100), 1);
  EXPECT_EQ(threads_for(0, 199, 100), 1);
  EXPECT_EQ(threads_for(0, 200, 100), std::min(2, threads_for(0)));
  EXPECT_EQ(threads_for(0, 1'000'000, 1), threads_for(0));
}

TEST(BlasThreads, CanBeRestored) {
  const auto before = set_blas_threads(2);
  if (!before) GTEST_SKIP() << "another BLAS than OpenBLAS";
  EXPECT_EQ(set_blas_threads(*before), 2);
}

TEST(Reduction, AProcessByItselfKeepsItsValue) {
  EXPECT_EQ(sum(3.0), 3.0);
  EXPECT_EQ(largest(-3.0), -3.0);
}

TEST(Session, OptionsAreWrittenAsOnACommandLine) {
  EXPECT_NO_THROW(set_petsc_options("-breccia_unknown 3"));
}

}  // namespace
}  // namespace breccia::parallel
