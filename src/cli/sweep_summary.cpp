#include "cli/sweep_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"
#include "results/sweep_spread.hpp"

namespace breccia::cli {
namespace {

constexpr std::size_t most_columns = 8;

/// A column of a table over time.
struct Column {
  std::size_t task = 0;
  std::string boundary;
  TimeWindow times;
  std::function<std::string(double)> text_at;
};

std::string modulus_at(const Curve& curve, double time) {
  return display(smoothed_at(curve, time), "Pa");
}

Column column_of(std::size_t task, const TaskCurve& curve) {
  const auto& modulus = curve.modulus;
  return {task, name_of(curve.test.boundary), {modulus.front().time, modulus.back().time}, [&modulus](double time) {
            return modulus_at(modulus, time);
          }};
}

Column column_of(const SpreadCurve& spread) {
  Curve means, deviations;
  for (const auto& at : spread.spreads) {
    means.push_back({at.time, at.mean});
    deviations.push_back({at.time, at.standard_deviation});
  }
  const TimeWindow times{means.front().time, means.back().time};
  return {spread.first_task, name_of(spread.test.test.boundary), times, [means, deviations](double time) {
            const double percent = 100.0 * smoothed_at(deviations, time) / smoothed_at(means, time);
            return fmt::format("{} +- {:.{}f} %", modulus_at(means, time), percent, percent < 10.0 ? 1 : 0);
          }};
}

/// A line of the table: its label, and the text of each column.
struct Row {
  std::string begin;
  std::vector<std::string> texts;
};

/// A line for each key that distinguishes the columns, with its values; a value stands only above the first column of
/// its task.
std::vector<Row> heading_of(const Sweep& sweep, const std::vector<Column>& columns, bool with_seeds) {
  std::vector<Row> rows;
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    if (sweep.keys[key].is_seed && !with_seeds) continue;
    Row row = {sweep.keys[key].label, {}};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool is_repeated = i > 0 && columns[i].task == columns[i - 1].task;
      row.texts.push_back(is_repeated ? "" : plain_text(sweep.tasks[columns[i].task].values[key]));
    }
    rows.push_back(std::move(row));
  }
  Row boundaries = {"time", {}};
  for (const auto& column : columns) boundaries.texts.push_back(column.boundary);
  rows.push_back(std::move(boundaries));
  return rows;
}

/// The moduli at whole decades of time.
std::vector<Row> moduli_of(const std::vector<Column>& columns) {
  TimeWindow all{std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& column : columns) {
    all = {std::min(all.begin, column.times.begin), std::max(all.end, column.times.end)};
  }
  std::vector<Row> rows;
  for (const double time : logarithmic_times(all, 1)) {
    Row row = {display_time(time), {}};
    for (const auto& column : columns) {
      const bool is_known = column.times.begin <= time && time <= column.times.end;
      row.texts.push_back(is_known ? column.text_at(time) : "-");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The rows as text, with right-aligned columns.
std::string aligned(const std::vector<Row>& rows) {
  constexpr std::size_t least = 12;
  std::size_t beginning = least;
  std::vector<std::size_t> widths(rows.front().texts.size(), least);
  for (const auto& row : rows) {
    beginning = std::max(beginning, row.begin.size());
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row.texts[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    auto line = fmt::format("{:>{}}", row.begin, beginning);
    for (std::size_t i = 0; i < widths.size(); ++i) line += fmt::format("  {:>{}}", row.texts[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// Mean and spread over the seeds for each stage; empty if no seeds were swept.
std::string tables_of_spreads(const Sweep& sweep, const SweepResult& result) {
  std::string text;
  std::size_t tasks = 0;
  for (const auto& stage : tested_stages(result)) {
    std::vector<Column> columns;
    for (const auto& spread : spread_over_seeds(sweep, stage_of(result, stage))) {
      columns.push_back(column_of(spread));
      tasks = std::max(tasks, spread.spreads.front().tasks);
    }
    if (columns.empty() || columns.size() > most_columns) continue;
    auto rows = heading_of(sweep, columns, false);
    std::ranges::copy(moduli_of(columns), std::back_inserter(rows));
    text += fmt::format("\n{}: modulus, mean and standard deviation over the seeds\n\n{}", stage, aligned(rows));
  }
  if (text.empty()) return text;
  return text + fmt::format(
                    "\nThe standard deviation is that of one box; that of the mean of {} boxes is {:.2g} times "
                    "smaller\n",
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
  auto spreads = tables_of_spreads(sweep, result);
  if (!spreads.empty()) return spreads;
  const auto shown = last_stage_of(result);
  std::vector<Column> columns;
  for (std::size_t task = 0; task < shown.size(); ++task) {
    for (const auto& curve : shown[task].curves) columns.push_back(column_of(task, curve));
  }
  if (columns.empty() || columns.size() > most_columns) return {};
  auto rows = heading_of(sweep, columns, true);
  std::ranges::copy(moduli_of(columns), std::back_inserter(rows));
  return fmt::format("\nModulus of the last stage\n\n{}", aligned(rows));
}

void refuse_failures(const Sweep& sweep, const SweepResult& result) {
  std::string failures;
  for (std::size_t task = 0; task < result.size(); ++task) {
    if (result[task].state != TaskState::failed) continue;
    failures += fmt::format("{}{}: {}", failures.empty() ? "" : "\n", sweep.tasks[task].name, result[task].error);
  }
  if (!failures.empty()) throw NumericalError(failures);
}

}  // namespace breccia::cli
