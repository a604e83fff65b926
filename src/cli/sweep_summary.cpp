#include "sweep_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "breccia/report/display.hpp"

namespace breccia::cli {
namespace {

constexpr std::size_t most_columns = 8;

/// A column of a table over time.
struct Column {
  std::array<std::string, 2> heading;
  TimeWindow times;
  std::function<std::string(double)> text_at;
};

std::string modulus_at(const Curve& curve, double time) {
  return display(smoothed_at(curve, time), "Pa");
}

Column column_of(const std::string& name, const TaskCurve& curve) {
  const auto& modulus = curve.modulus;
  return {{name, bound_of(curve)}, {modulus.front().time, modulus.back().time}, [&modulus](double time) {
            return modulus_at(modulus, time);
          }};
}

Column column_of(const std::string& name, const SpreadCurve& spread) {
  Curve means, deviations;
  for (const auto& at : spread.spreads) {
    means.push_back({at.time, at.mean});
    deviations.push_back({at.time, at.standard_deviation});
  }
  const TimeWindow times{means.front().time, means.back().time};
  return {{name, bound_of(spread.test)}, times, [means, deviations](double time) {
            const double percent = 100.0 * smoothed_at(deviations, time) / smoothed_at(means, time);
            return fmt::format("{} +- {:.{}f} %", modulus_at(means, time), percent, percent < 10.0 ? 1 : 0);
          }};
}

std::string table_of(const std::vector<Column>& columns) {
  TimeWindow all{std::numeric_limits<double>::infinity(), 0.0};
  std::vector<std::size_t> widths;
  for (const auto& [heading, times, text_at] : columns) {
    all = {std::min(all.begin, times.begin), std::max(all.end, times.end)};
    widths.push_back(std::max({heading[0].size(), heading[1].size(), text_at(times.begin).size(), std::size_t{12}}));
  }
  std::string text;
  for (std::size_t line = 0; line < 2; ++line) {
    const bool is_empty = std::ranges::all_of(columns, [&](const Column& one) { return one.heading[line].empty(); });
    if (is_empty) continue;
    text += fmt::format("\n{:>12}", line == 1 ? "time" : "");
    for (std::size_t i = 0; i < columns.size(); ++i)
      text += fmt::format("  {:>{}}", columns[i].heading[line], widths[i]);
  }
  for (const double time : logarithmic_times(all, 1)) {
    text += fmt::format("\n{:>12}", display_time(time));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& [heading, times, text_at] = columns[i];
      const bool is_known = times.begin <= time && time <= times.end;
      text += fmt::format("  {:>{}}", is_known ? text_at(time) : "-", widths[i]);
    }
  }
  return text + "\n";
}

/// Of each stage mean and spread over the seeds; empty where no seeds were swept.
std::string tables_of_spreads(const Sweep& sweep, const SweepResult& result) {
  std::string text;
  std::size_t tasks = 0;
  for (const auto& stage : tested_stages(result)) {
    const auto spreads = spread_over_seeds(sweep, stage_of(result, stage));
    std::vector<Column> columns;
    for (const auto& spread : spreads) {
      columns.push_back(column_of(name_without_seeds(sweep, sweep.tasks[spread.first_task]), spread));
      tasks = std::max(tasks, spread.spreads.front().tasks);
    }
    if (columns.empty() || columns.size() > most_columns) continue;
    text += fmt::format("\n{}: modulus, mean and standard deviation over the seeds\n{}", stage, table_of(columns));
  }
  if (text.empty()) return text;
  return text + fmt::format("\nThe standard deviation is that of one box; that of the mean of {} boxes is {:.2g} times smaller\n",
                            tasks, std::sqrt(static_cast<double>(tasks)));
}

}  // namespace

std::string heading_of(const Sweep& sweep, std::size_t task) {
  return fmt::format("task {} of {}: {}", task + 1, sweep.tasks.size(), sweep.tasks[task].name);
}

std::string table_of_tasks(const Sweep& sweep) {
  std::vector<std::vector<std::string>> columns{{"task"}};
  for (const auto& task : sweep.tasks) columns[0].push_back(task.name);
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    columns.push_back({sweep.keys[key].path});
    for (const auto& task : sweep.tasks) columns.back().push_back(plain_text(task.values[key]));
  }
  std::string text;
  for (std::size_t line = 0; line <= sweep.tasks.size(); ++line) {
    for (const auto& column : columns) {
      const auto width = std::ranges::max(column, {}, &std::string::size).size();
      text += fmt::format("  {:<{}}", column[line], &column == &columns.back() ? 0 : width);
    }
    text += "\n";
  }
  return text;
}

std::string closing_table(const Sweep& sweep, const SweepResult& result) {
  auto text = tables_of_spreads(sweep, result);
  if (!text.empty()) return text;
  const auto shown = last_stage_of(result);
  std::vector<Column> columns;
  for (std::size_t task = 0; task < shown.size(); ++task) {
    for (const auto& curve : shown[task].curves) columns.push_back(column_of(sweep.tasks[task].name, curve));
  }
  if (columns.empty() || columns.size() > most_columns) return {};
  return fmt::format("\nModulus of the last stage\n{}", table_of(columns));
}

}  // namespace breccia::cli
