#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/csv.hpp"

#include "sweep_results.hpp"

namespace breccia {

namespace {

constexpr auto extrapolated = "extrapolated";

/// Cells per side of a grid, as name_of_grid writes them; nothing for anything else.
std::optional<int> cells_of(const std::string& name) {
  if (name == extrapolated) return std::numeric_limits<int>::max();
  int cells = 0;
  const auto* const end_of_name = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data(), end_of_name, cells);
  return error == std::errc{} && end == end_of_name && cells > 0 ? std::optional(cells) : std::nullopt;
}

/// Throws FileError where a row is not one of curves.csv.
void require_as_written(const CsvTable& table, std::size_t row) {
  const double time = table.numbers("time_s")[row], modulus = table.numbers("modulus_Pa")[row];
  const bool is_sample = time > 0.0 && std::isfinite(time) && std::isfinite(modulus);
  if (is_sample && cells_of(table.text("cells")[row])) return;
  throw FileError(fmt::format("{}: not as `breccia run` writes it", table.place(row)));
}

/// How well a curve stands for others of its boundary.
std::pair<bool, int> preference(const TaskCurve& curve) {
  return {curve.method == name_of(Method::quasistatic), cells_of(curve.cells).value_or(0)};
}

/// One curve for each boundary of a stage.
std::vector<TaskCurve> stage_of(const std::vector<TaskCurve>& curves, const std::string& stage) {
  std::vector<TaskCurve> of_stage, best;
  std::ranges::copy_if(curves, std::back_inserter(of_stage),
                       [&](const TaskCurve& curve) { return curve.stage == stage; });
  if (of_stage.empty()) return best;
  const auto in_shear = std::ranges::find(of_stage, name_of(Load::shear), &TaskCurve::load);
  const auto load = in_shear == of_stage.end() ? of_stage.front().load : in_shear->load;
  for (const auto& curve : of_stage) {
    if (curve.load != load) continue;
    const auto rival = std::ranges::find(best, curve.boundary, &TaskCurve::boundary);
    if (rival == best.end()) {
      best.push_back(curve);
    } else if (preference(curve) > preference(*rival)) {
      *rival = curve;
    }
  }
  return best;
}

}  // namespace

bool TaskCurve::matches(const TaskCurve& other) const {
  return stage == other.stage && load == other.load && boundary == other.boundary && method == other.method &&
         cells == other.cells;
}

std::vector<TaskCurve> curves_of(const StudyResult& result) {
  std::vector<TaskCurve> curves;
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      curves.push_back({stage.name, name_of(test.load), name_of(test.boundary), name_of(test.method),
                        test.cells == 0 ? extrapolated : std::to_string(test.cells), test.modulus});
    }
  }
  return curves;
}

std::vector<TaskCurve> read_curves(const std::filesystem::path& directory) {
  const auto table = read_csv(directory / "curves.csv", {"stage", "load", "boundary", "method", "cells"});
  std::vector<TaskCurve> curves;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    require_as_written(table, row);
    const TaskCurve test{table.text("stage")[row],  table.text("load")[row],  table.text("boundary")[row],
                         table.text("method")[row], table.text("cells")[row], {}};
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

std::string bound_of(const TaskCurve& curve) {
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    if (name_of(boundary) == curve.boundary) return bound_of(boundary);
  }
  return curve.boundary;
}

}  // namespace breccia
