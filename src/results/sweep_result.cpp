#include "results/sweep_result.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "tables/csv.hpp"

namespace breccia {

namespace {

/// The test of a row of curves.csv. Throws FileError if the row does not have the format of a run.
TestId test_of(const CsvTable& table, std::size_t row) {
  const double time = table.numbers("time_s")[row], modulus = table.numbers("modulus_Pa")[row];
  const auto load = value_named<TestLoad>(table.text("load")[row]);
  const auto boundary = value_named<Boundary>(table.text("boundary")[row]);
  const auto method = value_named<Method>(table.text("method")[row]);
  const auto grid = grid_named(table.text("cells")[row]);
  const bool is_sample = time > 0.0 && std::isfinite(time) && std::isfinite(modulus);
  if (is_sample && load && boundary && method && grid) return {*load, *boundary, *method, *grid};
  throw FileError(fmt::format("{}: not as `breccia run` writes it", table.location(row)));
}

/// One curve for each boundary of a stage.
std::vector<TaskCurve> stage_of(const std::vector<TaskCurve>& curves, const std::string& stage) {
  std::vector<TaskCurve> of_stage, best;
  std::ranges::copy_if(curves, std::back_inserter(of_stage),
                       [&](const TaskCurve& curve) { return curve.stage == stage; });
  if (of_stage.empty()) return best;
  std::vector<TestLoad> loads;
  loads.reserve(of_stage.size());
  for (const auto& curve : of_stage) loads.push_back(curve.test.load);
  const auto load = main_shear(loads).value_or(loads.front());
  for (const auto& curve : of_stage) {
    if (curve.test.load != load) continue;
    const auto rival =
        std::ranges::find_if(best, [&](const TaskCurve& other) { return other.test.boundary == curve.test.boundary; });
    if (rival == best.end()) {
      best.push_back(curve);
    } else if (is_preferred(curve.test, rival->test)) {
      *rival = curve;
    }
  }
  return best;
}

}  // namespace

std::vector<TaskCurve> curves_of(const StudyResult& result) {
  std::vector<TaskCurve> curves;
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) curves.push_back({stage.name, test.id, test.modulus});
  }
  return curves;
}

std::vector<TaskCurve> read_curves(const std::filesystem::path& directory) {
  const auto table = read_csv(directory / "curves.csv", {"stage", "load", "boundary", "method", "cells"});
  std::vector<TaskCurve> curves;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const TaskCurve test{table.text("stage")[row], test_of(table, row), {}};
    if (curves.empty() || !curves.back().matches(test)) curves.push_back(test);
    curves.back().modulus.push_back({table.numbers("time_s")[row], table.numbers("modulus_Pa")[row]});
  }
  return curves;
}

std::vector<std::string> tested_stages(const SweepResult& result) {
  std::vector<std::string> stages;
  for (const auto& task : result) {
    for (const auto& curve : task.curves) {
      if (std::ranges::find(stages, curve.stage) == stages.end()) stages.push_back(curve.stage);
    }
  }
  return stages;
}

SweepResult stage_of(const SweepResult& result, const std::string& stage) {
  auto shown = result;
  for (auto& task : shown) task.curves = stage_of(task.curves, stage);
  return shown;
}

SweepResult last_stage_of(const SweepResult& result) {
  auto shown = result;
  for (auto& task : shown) {
    if (!task.curves.empty()) task.curves = stage_of(task.curves, task.curves.back().stage);
  }
  return shown;
}

}  // namespace breccia
