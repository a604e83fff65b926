#include "results/sweep_tables.hpp"

#include <functional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "deck/swept_quantities.hpp"
#include "io/text_file.hpp"
#include "results/sweep_spread.hpp"
#include "results/test_columns.hpp"
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

void write_all_curves(const std::filesystem::path& file, const Sweep& sweep, const SweepResult& result) {
  KeyColumns keys(sweep, [](const SweptKey&) { return true; });
  TestColumns curves;
  std::vector<std::string> tasks;
  std::vector<double> times, moduli;
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (const auto& curve : result[i].curves) {
      for (const auto& [time, modulus] : curve.modulus) {
        tasks.push_back(sweep.tasks[i].name);
        keys.add(sweep.tasks[i]);
        curves.add(curve.stage, curve.test);
        times.push_back(time);
        moduli.push_back(modulus);
      }
    }
  }
  if (times.empty()) return remove_files(file.parent_path(), std::vector{file.filename().string()});
  std::vector<CsvColumn> table{{"task", tasks}};
  keys.append_to(table);
  curves.append_to(table);
  table.insert(table.end(), {{"time_s", times}, {"modulus_Pa", moduli}});
  write_csv(file, table);
}

void write_spreads(const std::filesystem::path& file, const Sweep& sweep, const SweepResult& result) {
  KeyColumns keys(sweep, [](const SweptKey& key) { return !key.is_seed; });
  TestColumns tests;
  std::vector<double> times, counts, means, deviations, smallest, largest;
  for (const auto& [task, test, spreads] : spread_over_seeds(sweep, result)) {
    for (const auto& spread : spreads) {
      keys.add(sweep.tasks[task]);
      tests.add(test.stage, test.test);
      times.push_back(spread.time);
      counts.push_back(static_cast<double>(spread.tasks));
      means.push_back(spread.mean);
      deviations.push_back(spread.standard_deviation);
      smallest.push_back(spread.smallest);
      largest.push_back(spread.largest);
    }
  }
  if (times.empty()) return remove_files(file.parent_path(), std::vector{file.filename().string()});
  std::vector<CsvColumn> table;
  keys.append_to(table);
  tests.append_to(table);
  table.insert(table.end(), {{"time_s", times},
                             {"tasks", counts},
                             {"mean_modulus_Pa", means},
                             {"standard_deviation_Pa", deviations},
                             {"smallest_Pa", smallest},
                             {"largest_Pa", largest}});
  write_csv(file, table);
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

}  // namespace

void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result) {
  write_all_curves(directory / "sweep.csv", sweep, result);
  write_spreads(directory / "spread.csv", sweep, result);
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
  const Json json = {{"program", "breccia"},
                     {"version", BRECCIA_VERSION},
                     {"title", study.title},
                     {"deck", provenance.deck.string()},
                     {"deck_text", provenance.deck_text},
                     {"overrides", sweep.overrides},
                     {"keys", std::move(keys)},
                     {"quantities", std::move(quantities)},
                     {"tasks", std::move(tasks)}};
  write_text(directory / "sweep.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace breccia
