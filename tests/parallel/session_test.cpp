#include "parallel/session.hpp"

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "parallel/blas_threads.hpp"
#include "parallel/reduction.hpp"

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
