#include "quasistatic/operator/cell_sweep.hpp"

#include <new>

#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

TEST(CellSweep, AnExceptionLeavesItsThreads) {
  const CellSweep sweep({2, 2, 40}, {{2, 2, 40}, 4, 8});
  const auto short_of_memory = [](int, int first_plane, int) {
    if (first_plane == 8) throw std::bad_alloc();
  };
  EXPECT_THROW(sweep.for_slabs(2, short_of_memory), std::bad_alloc);
}

}  // namespace
}  // namespace breccia::quasistatic
