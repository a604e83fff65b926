#include "results/sweep_tables.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "deck/swept_quantities.hpp"
#include "io/text_file.hpp"
#include "results/complex_columns.hpp"
#include "results/sweep_spread.hpp"
#include "results/test_columns.hpp"
#include "study/abscissa_words.hpp"
#include "tables/csv.hpp"

namespace breccia {

namespace {

using Json = nlohmann::ordered_json;

/// The columns of swept keys, as text.
class KeyColumns {
 public:
  KeyColumns(const Sweep& sweep, const std::function<bool(const SweptKey&)>& has_column) : sweep_(sweep) {
    for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
      if (has_column(sweep.keys[key])) keys_.push_back(key);
    }
    columns_.resize(keys_.size());
  }

  void add(const SweepTask& task) {
    for (std::size_t i = 0; i < keys_.size(); ++i) columns_[i].push_back(plain_text(task.values[keys_[i]]));
  }

  void append_to(std::vector<CsvColumn>& table) const {
    for (std::size_t i = 0; i < keys_.size(); ++i) table.push_back({sweep_.keys[keys_[i]].path, columns_[i]});
  }

 private:
  const Sweep& sweep_;
  std::vector<std::size_t> keys_;
  std::vector<std::vector<std::string>> columns_;
};

/// The columns that name the task and the test of each row.
class CurveColumns {
 public:
  explicit CurveColumns(const Sweep& sweep) : sweep_(sweep), keys_(sweep, [](const SweptKey&) { return true; }) {}

  void add(std::size_t task, const TaskCurve& curve) {
    tasks_.push_back(sweep_.tasks[task].name);
    keys_.add(sweep_.tasks[task]);
    tests_.add(curve.stage, curve.test);
  }

  [[nodiscard]] std::vector<CsvColumn> table() const {
    std::vector<CsvColumn> table{{"task", tasks_}};
    keys_.append_to(table);
    tests_.append_to(table);
    return table;
  }

 private:
  const Sweep& sweep_;
  std::vector<std::string> tasks_;
  KeyColumns keys_;
  TestColumns tests_;
};

/// The columns that name the test of each row of a table of spreads, and count its tasks.
class SpreadColumns {
 public:
  explicit SpreadColumns(const Sweep& sweep)
      : sweep_(sweep), keys_(sweep, [](const SweptKey& key) { return !key.is_seed; }) {}

  void add(const SpreadCurve& curve, std::size_t tasks) {
    keys_.add(sweep_.tasks[curve.first_task]);
    tests_.add(curve.test.stage, curve.test.test);
    counts_.push_back(static_cast<double>(tasks));
  }

  [[nodiscard]] std::vector<CsvColumn> table(const CsvColumn& abscissa) const {
    std::vector<CsvColumn> table;
    keys_.append_to(table);
    tests_.append_to(table);
    table.insert(table.end(), {abscissa, {"tasks", counts_}});
    return table;
  }

 private:
  const Sweep& sweep_;
  KeyColumns keys_;
  TestColumns tests_;
  std::vector<double> counts_;
};

/// The columns of the statistics of one quantity.
struct StatisticsColumns {
  std::vector<double> means, deviations, smallest, largest;

  void add(const SeedSpread& spread) {
    means.push_back(spread.mean);
    deviations.push_back(spread.standard_deviation);
    smallest.push_back(spread.smallest);
    largest.push_back(spread.largest);
  }

  /// Adds them under the names of mean, standard deviation, smallest and largest value.
  void append_to(std::vector<CsvColumn>& table, const std::array<std::string, 4>& names) const {
    table.insert(table.end(), {{names[0], means}, {names[1], deviations}, {names[2], smallest}, {names[3], largest}});
  }
};

void write_or_remove(const std::filesystem::path& file, const std::vector<CsvColumn>& table, bool has_rows) {
  if (has_rows) return write_csv(file, table);
  remove_files(file.parent_path(), std::vector{file.filename().string()});
}

void write_all_curves(const std::filesystem::path& file, const Sweep& sweep, const SweepResult& result) {
  CurveColumns curves(sweep);
  std::vector<double> times, moduli;
  std::vector<std::string> errors;
  for (std::size_t task = 0; task < result.size(); ++task) {
    for (const auto& curve : result[task].curves) {
      for (const auto& [time, modulus] : curve.modulus) {
        curves.add(task, curve);
        times.push_back(time);
        moduli.push_back(modulus);
        errors.push_back(text_if_known(curve.error_at(time)));
      }
    }
  }
  auto table = curves.table();
  table.insert(table.end(), {{"time_s", times}, {"modulus_Pa", moduli}, {"error", errors}});
  write_or_remove(file, table, !times.empty());
}

void write_all_complex_moduli(const std::filesystem::path& file, const Sweep& sweep, const SweepResult& result) {
  CurveColumns curves(sweep);
  ComplexColumns moduli;
  for (std::size_t task = 0; task < result.size(); ++task) {
    for (const auto& curve : result[task].curves) {
      for (const auto& sample : curve.in_frequency) {
        curves.add(task, curve);
        moduli.add(sample);
      }
    }
  }
  auto table = curves.table();
  moduli.append_to(table);
  write_or_remove(file, table, !moduli.empty());
}

void write_spreads(const std::filesystem::path& file, const Sweep& sweep, const std::vector<SpreadCurve>& curves) {
  SpreadColumns tests(sweep);
  std::vector<double> times;
  StatisticsColumns moduli;
  for (const auto& curve : curves) {
    for (const auto& [time, modulus] : curve.in_time) {
      tests.add(curve, modulus.tasks);
      times.push_back(time);
      moduli.add(modulus);
    }
  }
  auto table = tests.table({"time_s", times});
  moduli.append_to(table, {"mean_modulus_Pa", "standard_deviation_Pa", "smallest_Pa", "largest_Pa"});
  write_or_remove(file, table, !times.empty());
}

void write_complex_spreads(const std::filesystem::path& file, const Sweep& sweep,
                           const std::vector<SpreadCurve>& curves) {
  SpreadColumns tests(sweep);
  std::vector<double> frequencies;
  StatisticsColumns absolutes, phases;
  for (const auto& curve : curves) {
    for (const auto& [frequency, absolute, phase] : curve.in_frequency) {
      tests.add(curve, absolute.tasks);
      frequencies.push_back(frequency);
      absolutes.add(absolute);
      phases.add(phase);
    }
  }
  auto table = tests.table({"angular_frequency_rad_per_s", frequencies});
  absolutes.append_to(
      table, {"mean_absolute_Pa", "standard_deviation_absolute_Pa", "smallest_absolute_Pa", "largest_absolute_Pa"});
  phases.append_to(table,
                   {"mean_phase_rad", "standard_deviation_phase_rad", "smallest_phase_rad", "largest_phase_rad"});
  write_or_remove(file, table, !frequencies.empty());
}

Json json_of(const Sweep& sweep, const SweepTask& task, const TaskResult& result,
             const std::vector<std::string>& may_replace) {
  Json values = Json::object();
  for (std::size_t i = 0; i < sweep.keys.size(); ++i) {
    std::visit([&](const auto& value) { values[sweep.keys[i].path] = value; }, task.values[i]);
  }
  Json json = {{"name", task.name},
               {"values", std::move(values)},
               {"hash", task.study.provenance.hash},
               {"state", name_of(result.state)},
               {"wall_time_s", result.state == TaskState::done ? Json(result.seconds) : Json()}};
  if (result.state == TaskState::failed) json["error"] = result.error;
  if (result.state != TaskState::done && !may_replace.empty()) json["may_replace"] = may_replace;
  return json;
}

/// The dimensions of the boxes of all tasks; nothing where they differ.
std::optional<int> common_dimensions(const Sweep& sweep) {
  std::optional<int> common;
  for (const auto& task : sweep.tasks) {
    for (const auto& stage : task.study.stages) {
      if (common.value_or(stage.dimensions()) != stage.dimensions()) return std::nullopt;
      common = stage.dimensions();
    }
  }
  return common;
}

}  // namespace

void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result) {
  write_all_curves(directory / "sweep.csv", sweep, result);
  write_all_complex_moduli(directory / "sweep_dynamic.csv", sweep, result);
  const auto spreads = spread_over_seeds(sweep, result);
  write_spreads(directory / "spread.csv", sweep, spreads);
  write_complex_spreads(directory / "spread_dynamic.csv", sweep, spreads);
}

void write_sweep_record(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result,
                        const std::vector<std::vector<std::string>>& replaceable) {
  Json tasks = Json::array();
  for (std::size_t i = 0; i < result.size(); ++i) {
    tasks.push_back(json_of(sweep, sweep.tasks[i], result[i], replaceable[i]));
  }
  Json keys = Json::array();
  for (const auto& key : sweep.keys) keys.push_back(key.path);
  Json quantities = Json::object();
  for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
    const auto swept = swept_quantity(sweep, key);
    if (swept) quantities[sweep.keys[key].path] = {{"unit", swept->unit}, {"numbers", swept->numbers}};
  }
  const auto& study = sweep.tasks.front().study;
  const auto& provenance = study.provenance;
  Json json = {{"program", "breccia"},
               {"version", BRECCIA_VERSION},
               {"title", study.title},
               {"deck", provenance.deck.string()},
               {"deck_text", provenance.deck_text},
               {"overrides", sweep.overrides},
               {"keys", std::move(keys)},
               {"quantities", std::move(quantities)},
               {"tasks", std::move(tasks)}};
  const auto& tests = study.tests;
  if (const auto dimensions = common_dimensions(sweep)) json["dimensions"] = *dimensions;
  if (tests.by_frequency) json["frequencies_Hz"] = {hertz_of(tests.last_time), hertz_of(tests.first_time)};
  write_text(directory / "sweep.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace breccia
