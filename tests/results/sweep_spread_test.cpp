#include "breccia/results/sweep_spread.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// Two grids, each with three seeds.
Sweep sweep_over_grids_and_seeds() {
  Sweep sweep;
  sweep.keys = {{.path = "stages.*.cells", .label = "cells"},
                {.path = "stages.*.packing.seed", .label = "seed", .is_seed = true}};
  for (const std::int64_t cells : {10, 20}) {
    for (const std::int64_t seed : {1, 2, 3}) {
      SweepTask task;
      task.labels = {"cells-" + std::to_string(cells), "seed-" + std::to_string(seed)};
      task.name = task.labels[0] + "_" + task.labels[1];
      task.values = {cells, seed};
      sweep.tasks.push_back(task);
    }
  }
  return sweep;
}

TEST(SweepSpread, SpreadsAreOverTheSeedsAlone) {
  const auto sweep = sweep_over_grids_and_seeds();
  SweepResult result(6);
  const auto done = [&](std::size_t task, double modulus) {
    result[task] = {TaskState::done, {{"HB-1", {.grid = TestGrid(10)}, {{1.0, modulus}}}}};
  };
  done(0, 1e6);
  done(1, 2e6);
  done(2, 6e6);
  done(4, 5e6);  // alone
  const auto curves = spread_over_seeds(sweep, result);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].first_task, 0U);
  ASSERT_EQ(curves[0].spreads.size(), 1U);
  const auto& spread = curves[0].spreads[0];
  EXPECT_EQ(spread.time, 1.0);
  EXPECT_EQ(spread.tasks, 3U);
  EXPECT_DOUBLE_EQ(spread.mean, 3e6);
  EXPECT_DOUBLE_EQ(spread.standard_deviation, std::sqrt(7.0) * 1e6);
  EXPECT_EQ(spread.smallest, 1e6);
  EXPECT_EQ(spread.largest, 6e6);
}

TEST(SweepSpread, NamesOfTasksLoseTheirSeeds) {
  const auto sweep = sweep_over_grids_and_seeds();
  EXPECT_EQ(name_without_seeds(sweep, sweep.tasks[4]), "cells-20");
}

}  // namespace
}  // namespace breccia
