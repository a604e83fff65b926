#include "cli/sweep_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"
#include "results/sweep_spread.hpp"

namespace breccia::cli {
namespace {

constexpr std::size_t widest_table = 140;  ///< characters of a line; a wider table would be broken into several

/// A column of a table over time or over frequency.
struct Column {
  std::size_t task = 0;
  std::string boundary;
  TimeWindow range;                            ///< of times [s], or of angular frequencies [rad/s]
  std::function<std::string(double)> text_at;  ///< the text at one of them
};

std::string modulus_at(const Curve& curve, double time) {
  return display(smoothed_at(curve, time), "Pa");
}

/// A value in words, and its deviation as a share of it: "1.23 MPa +- 3.4 %".
std::string with_deviation(const std::string& mean, double share) {
  const double percent = 100.0 * share;
  return fmt::format("{} +- {:.{}f} %", mean, percent, percent < 10.0 ? 1 : 0);
}

/// The same of an error; the value alone where it is not known.
std::string with_error(const std::string& value, const std::optional<double>& error) {
  return error ? with_deviation(value, *error) : value;
}

/// A phase [rad] in degrees.
std::string degrees(double phase) {
  return fmt::format("{:.2f}", phase * 180.0 / std::numbers::pi);
}

/// The one of these samples whose angular frequency is nearest to the given one [rad/s].
template <class SampleAtFrequency>
const SampleAtFrequency& nearest(const std::vector<SampleAtFrequency>& samples, double angular_frequency) {
  return *std::ranges::min_element(samples, {}, [angular_frequency](const SampleAtFrequency& sample) {
    return std::abs(std::log(sample.angular_frequency / angular_frequency));
  });
}

Column column_in_time(std::size_t task, const TaskCurve& curve) {
  const auto& modulus = curve.modulus;
  return {task, name_of(curve.test.boundary), {modulus.front().time, modulus.back().time}, [&curve](double time) {
            return with_error(modulus_at(curve.modulus, time), curve.error_at(time));
          }};
}

Column column_in_frequency(std::size_t task, const TaskCurve& curve) {
  const auto& moduli = curve.in_frequency;
  return {task,
          name_of(curve.test.boundary),
          {moduli.front().angular_frequency, moduli.back().angular_frequency},
          [&moduli](double frequency) {
            const auto& [omega, storage, loss, error] = nearest(moduli, frequency);
            return fmt::format("{} {:>5} deg", with_error(display(std::hypot(storage, loss), "Pa"), error),
                               degrees(std::atan2(loss, storage)));
          }};
}

Column column_in_time(const SpreadCurve& spread) {
  Curve means, deviations;
  for (const auto& [time, modulus] : spread.in_time) {
    means.push_back({time, modulus.mean});
    deviations.push_back({time, modulus.standard_deviation});
  }
  const TimeWindow times{means.front().time, means.back().time};
  return {spread.first_task, name_of(spread.test.test.boundary), times, [means, deviations](double time) {
            return with_deviation(modulus_at(means, time), smoothed_at(deviations, time) / smoothed_at(means, time));
          }};
}

Column column_in_frequency(const SpreadCurve& spread) {
  const TimeWindow range{spread.in_frequency.front().angular_frequency, spread.in_frequency.back().angular_frequency};
  return {
      spread.first_task, name_of(spread.test.test.boundary), range, [spreads = spread.in_frequency](double frequency) {
        const auto& [omega, absolute, phase] = nearest(spreads, frequency);
        return fmt::format("{} {:>5} +- {} deg",
                           with_deviation(display(absolute.mean, "Pa"), absolute.standard_deviation / absolute.mean),
                           degrees(phase.mean), degrees(phase.standard_deviation));
      }};
}

/// Whether a curve has values over this abscissa: not every test has complex moduli.
template <class SomeCurve>
bool is_known_over(Abscissa abscissa, const SomeCurve& curve) {
  return abscissa == Abscissa::time || !curve.in_frequency.empty();
}

Abscissa abscissa_of(const Sweep& sweep) {
  return sweep.tasks.front().study.tests.abscissa();
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
  Row boundaries = {abscissa_of(sweep) == Abscissa::time ? "time" : "frequency", {}};
  for (const auto& column : columns) boundaries.texts.push_back(column.boundary);
  rows.push_back(std::move(boundaries));
  return rows;
}

/// The texts at whole decades of time, or of the frequency in hertz.
std::vector<Row> texts_of(const std::vector<Column>& columns, Abscissa abscissa) {
  const bool is_time = abscissa == Abscissa::time;
  const double unit = is_time ? 1.0 : 2.0 * std::numbers::pi;
  TimeWindow all{std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& column : columns) {
    all = {std::min(all.begin, column.range.begin / unit), std::max(all.end, column.range.end / unit)};
  }
  constexpr double rounding = 1e-9;
  std::vector<Row> rows;
  for (const double place : logarithmic_times(all, 1)) {
    Row row = {is_time ? display_time(place) : display(place, "Hz"), {}};
    for (const auto& column : columns) {
      const double at = place * unit;
      const auto& [begin, end] = column.range;
      const bool is_known = begin * (1.0 - rounding) <= at && at <= end * (1.0 + rounding);
      row.texts.push_back(is_known ? column.text_at(at) : "-");
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
  const auto abscissa = abscissa_of(sweep);
  const auto* const quantity = abscissa == Abscissa::time ? "modulus" : "absolute value and phase of the modulus";
  for (const auto& stage : tested_stages(result)) {
    std::vector<Column> columns;
    const auto spreads = spread_over_seeds(sweep, stage_of(result, stage));
    for (const auto& spread : spreads) {
      if (!is_known_over(abscissa, spread)) continue;
      columns.push_back(abscissa == Abscissa::time ? column_in_time(spread) : column_in_frequency(spread));
      tasks = std::max(tasks, spread.in_time.front().modulus.tasks);
    }
    if (columns.empty()) continue;
    auto rows = heading_of(sweep, columns, false);
    std::ranges::copy(texts_of(columns, abscissa), std::back_inserter(rows));
    const auto table = aligned(rows);
    if (table.find('\n') > widest_table) continue;
    text += fmt::format("\n{}: {}, mean and standard deviation over the seeds\n\n{}", stage, quantity, table);
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
  const auto abscissa = abscissa_of(sweep);
  std::vector<Column> columns;
  for (std::size_t task = 0; task < shown.size(); ++task) {
    for (const auto& curve : shown[task].curves) {
      if (!is_known_over(abscissa, curve)) continue;
      columns.push_back(abscissa == Abscissa::time ? column_in_time(task, curve) : column_in_frequency(task, curve));
    }
  }
  if (columns.empty()) return {};
  auto rows = heading_of(sweep, columns, true);
  std::ranges::copy(texts_of(columns, abscissa), std::back_inserter(rows));
  const auto table = aligned(rows);
  if (table.find('\n') > widest_table) return {};
  const auto* const title = abscissa == Abscissa::time ? "Modulus" : "Absolute value and phase of the modulus";
  const auto is_known = [](const std::optional<double>& error) { return error.has_value(); };
  const bool has_errors = std::ranges::any_of(shown, [&is_known](const TaskResult& task) {
    return std::ranges::any_of(
        task.curves, [&is_known](const TaskCurve& curve) { return std::ranges::any_of(curve.errors, is_known); });
  });
  return fmt::format("\n{} of the last stage{}\n\n{}", title, has_errors ? ", +- the error" : "", table);
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
