#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"
#include "study/two_stages.hpp"

namespace breccia::test {

/// A task of a sweep over seeds and gaps.
inline SweepTask task_with(std::int64_t seed, const std::string& gap) {
  SweepTask task;
  task.labels = {"seed-" + std::to_string(seed), "gap-" + gap};
  task.name = task.labels[0] + "_" + task.labels[1];
  task.values = {seed, gap};
  task.study = two_stages();
  task.study.title = "seeds and gaps";
  task.study.provenance.hash = "hash of " + task.name;
  task.study.provenance.deck = "deck.toml";
  return task;
}

/// Three seeds with each of two gaps.
inline Sweep seeds_and_gaps() {
  Sweep sweep;
  sweep.keys = {{"stages.*.packing.seed", "seed", true}, {"stages.*.filler.gap", "gap", false}};
  for (const std::int64_t seed : {1, 2, 3}) {
    for (const auto* gap : {"1 um", "2 um"}) sweep.tasks.push_back(task_with(seed, gap));
  }
  return sweep;
}

/// A task that is done, with one curve of its stage "A".
inline TaskResult done_with(Curve modulus, const TestId& test = {.grid = TestGrid(12)}) {
  return {.state = TaskState::done, .curves = {{"A", test, std::move(modulus)}}, .seconds = 2.0};
}

}  // namespace breccia::test
