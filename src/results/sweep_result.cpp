#include "results/sweep_result.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/best_tests.hpp"
#include "results/error_file.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {

namespace {

[[noreturn]] void refuse(const CsvTable& table, std::size_t row) {
  throw FileError(fmt::format("{}: not as `breccia run` writes it", table.location(row)));
}

/// The sample of a row of curves.csv. Throws FileError if the row does not have the format of a run.
Sample sample_of(const CsvTable& table, std::size_t row) {
  const Sample sample{table.numbers("time_s")[row], table.numbers("modulus_Pa")[row]};
  if (!(sample.time > 0.0) || !std::isfinite(sample.time) || !std::isfinite(sample.modulus)) refuse(table, row);
  return sample;
}

/// The curve of a row of a table of tests.
TaskCurve& curve_of(const CsvTable& table, std::size_t row, std::vector<TaskCurve>& curves) {
  const TaskCurve named{table.text("stage")[row], id_of_row(table, row), {}};
  const auto curve = std::ranges::find_if(curves, [&](const TaskCurve& one) { return one.matches(named); });
  if (curve == curves.end()) refuse(table, row);
  return *curve;
}

/// Adds the errors of errors.csv, which earlier versions did not write.
void add_errors(const std::filesystem::path& file, std::vector<TaskCurve>& curves) {
  if (!std::filesystem::exists(file)) return;
  const auto table = read_error_table(file);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& curve = curve_of(table, row, curves);
    const auto next = curve.errors.size();
    const bool is_its = next < curve.modulus.size() && table.numbers("time_s")[row] == curve.modulus[next].time;
    if (!is_its) refuse(table, row);
    curve.errors.push_back(error_in(table, row).whole());
  }
  const auto lacks_errors = [](const TaskCurve& curve) {
    return !curve.errors.empty() && curve.errors.size() < curve.modulus.size();
  };
  if (std::ranges::any_of(curves, lacks_errors)) {
    throw FileError(fmt::format("{}: not an error for each row of curves.csv", file.string()));
  }
}

/// Adds the complex moduli of dynamic.csv; a run whose series all vanish has no such table.
void add_complex_moduli(const std::filesystem::path& file, std::vector<TaskCurve>& curves) {
  if (!std::filesystem::exists(file)) return;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells", "error"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& curve = curve_of(table, row, curves);
    const double omega = table.numbers("angular_frequency_rad_per_s")[row];
    curve.in_frequency.push_back({omega, table.numbers("storage_modulus_Pa")[row],
                                  table.numbers("loss_modulus_Pa")[row], curve.error_at(1.0 / omega)});
  }
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

std::optional<double> TaskCurve::error_at(double time) const {
  if (errors.empty()) return std::nullopt;
  const auto nearest = std::ranges::min_element(
      modulus, {}, [time](const Sample& sample) { return std::abs(std::log(sample.time / time)); });
  const auto place = static_cast<std::size_t>(nearest - modulus.begin());
  return place < errors.size() ? errors[place] : std::nullopt;
}

std::vector<TaskCurve> curves_of(const StudyResult& result) {
  std::vector<TaskCurve> curves;
  for (const auto& stage : result.stages) {
    const auto best = best_tests(stage);
    for (const auto& test : stage.tests) {
      auto& curve = curves.emplace_back(TaskCurve{stage.name, test.id, test.modulus});
      for (const auto& error : test.errors) curve.errors.push_back(error.whole());
      if (std::ranges::find(best, &test) != best.end()) curve.in_frequency = test.in_frequency;
    }
  }
  return curves;
}

std::vector<TaskCurve> read_curves(const std::filesystem::path& directory) {
  const auto table = read_csv(directory / "curves.csv", {"stage", "load", "boundary", "method", "cells"});
  std::vector<TaskCurve> curves;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const TaskCurve named{table.text("stage")[row], id_of_row(table, row), {}};
    if (curves.empty() || !curves.back().matches(named)) curves.push_back(named);
    curves.back().modulus.push_back(sample_of(table, row));
  }
  return curves;
}

std::vector<TaskCurve> read_task_curves(const std::filesystem::path& directory, Abscissa abscissa) {
  auto curves = read_curves(directory);
  add_errors(directory / "errors.csv", curves);
  if (abscissa == Abscissa::frequency) add_complex_moduli(directory / "dynamic.csv", curves);
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
