#include "page/sweep_report.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "page/page.hpp"
#include "page/report_data.hpp"
#include "page/report_tables.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The error at each time, null where it is not known.
Json errors_of(const TaskCurve& curve) {
  Json errors = Json::array();
  for (const auto& error : curve.errors) errors.push_back(error ? Json(*error) : Json());
  return errors;
}

Json json_of(std::size_t task, const TaskCurve& curve) {
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : curve.modulus) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  Json json = {{"task", task},
               {"stage", curve.stage},
               {"load", name_of(curve.test.load)},
               {"boundary", name_of(curve.test.boundary)},
               {"method", name_of(curve.test.method)},
               {"cells", name_of(curve.test.grid)},
               {"time_s", rounded(std::move(times))},
               {"modulus_Pa", rounded(std::move(moduli))},
               {"error", errors_of(curve)}};
  if (curve.in_frequency.empty()) return json;
  std::vector<double> frequencies, storage, loss;
  for (const auto& sample : curve.in_frequency) {
    frequencies.push_back(sample.angular_frequency);
    storage.push_back(sample.storage);
    loss.push_back(sample.loss);
  }
  json["angular_frequency_rad_per_s"] = rounded(std::move(frequencies));
  json["storage_modulus_Pa"] = rounded(std::move(storage));
  json["loss_modulus_Pa"] = rounded(std::move(loss));
  return json;
}

/// The curves of each finished task, from its files.
std::vector<std::vector<TaskCurve>> stored_curves(const fs::path& directory, const Json& sweep) {
  const auto& tasks = sweep.at("tasks");
  const auto abscissa = sweep.contains("frequencies_Hz") ? Abscissa::frequency : Abscissa::time;
  std::vector<std::vector<TaskCurve>> curves(tasks.size());
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    if (tasks[task].at("state") != "done") continue;
    const auto name = tasks[task].at("name").get<std::string>();
    if (!stays_in_directory(name)) {
      throw FileError(fmt::format("sweep.json: \"{}\" is not a name that `breccia run` gives to a task", name));
    }
    curves[task] = read_task_curves(directory / name, abscissa);
  }
  return curves;
}

/// A measurement that a stage is compared with, by the names of both.
using Measured = std::pair<std::string, std::string>;

/// The measured shear moduli of a table of comparisons, its columns `values`, by measurement and by its column
/// `abscissa`. The page of a sweep has no curves of Young's modulus.
std::map<Measured, std::map<double, std::vector<double>>> measured_in(const fs::path& file, const std::string& abscissa,
                                                                      const std::vector<std::string>& values) {
  std::map<Measured, std::map<double, std::vector<double>>> measured;
  if (!is_there(file)) return measured;
  const auto table = read_csv(file, {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.has("modulus") && table.text("modulus")[row] != name_of(ModulusKind::shear)) continue;
    auto& found = measured[{table.text("stage")[row], table.text("measurement")[row]}][table.numbers(abscissa)[row]];
    found.clear();  // a measurement has a row for each boundary
    for (const auto& name : values) found.push_back(table.numbers(name)[row]);
  }
  return measured;
}

/// The measurements that the finished tasks are compared with in one of their tables, each of them once for a stage.
Json measurements_of(const fs::path& directory, const Json& tasks, const std::string& file, const std::string& abscissa,
                     const std::vector<std::string>& values) {
  Json measurements = Json::array();
  std::set<Measured> known;
  for (const auto& task : tasks) {
    if (task.at("state") != "done") continue;
    const auto table = directory / task.at("name").get<std::string>() / file;
    for (const auto& [name, samples] : measured_in(table, abscissa, values)) {
      if (!known.insert(name).second) continue;
      std::vector<double> places;
      std::vector<std::vector<double>> columns(values.size());
      for (const auto& [place, row] : samples) {
        places.push_back(place);
        for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
      }
      Json json = {{"stage", name.first}, {"measurement", name.second}, {abscissa, rounded(std::move(places))}};
      for (std::size_t i = 0; i < values.size(); ++i) json[values[i]] = rounded(std::move(columns[i]));
      measurements.push_back(std::move(json));
    }
  }
  return measurements;
}

Json data_of(const fs::path& directory, Json sweep, const std::vector<std::vector<TaskCurve>>& curves_of_tasks) {
  Json curves = Json::array(), tables = Json::object();
  for (std::size_t task = 0; task < curves_of_tasks.size(); ++task) {
    for (const auto& curve : curves_of_tasks[task]) curves.push_back(json_of(task, curve));
  }
  auto text_columns = text_columns_of_tests();
  for (const auto& key : sweep.at("keys")) text_columns.push_back(key.get<std::string>());
  for (const auto* name : {"spread.csv", "spread_dynamic.csv"}) {
    auto spread = table_for_page(directory / name, text_columns);
    if (!spread.empty()) tables[name] = std::move(spread);
  }
  const auto& tasks = sweep.at("tasks");
  auto measurements = measurements_of(directory, tasks, "comparison.csv", "time_s", {"measured_Pa"});
  auto in_frequency = measurements_of(directory, tasks, "comparison_dynamic.csv", "angular_frequency_rad_per_s",
                                      {"measured_storage_modulus_Pa", "measured_loss_modulus_Pa"});
  return {{"sweep", std::move(sweep)},
          {"curves", std::move(curves)},
          {"tables", std::move(tables)},
          {"measurements", std::move(measurements)},
          {"measurements_in_frequency", std::move(in_frequency)}};
}

}  // namespace

PageData sweep_page_data(const fs::path& directory) {
  return read_page_data(directory / "sweep.json", [&](Json sweep) {
    const auto curves = stored_curves(directory, sweep);
    return data_of(directory, std::move(sweep), curves);
  });
}

void write_sweep_report(const fs::path& directory) {
  const auto page = sweep_page_data(directory);
  write_text(directory / "report.html", sweep_page(page.title, page.json));
}

void write_sweep_report(const fs::path& directory, const SweepResult& result) {
  std::vector<std::vector<TaskCurve>> curves;
  for (const auto& task : result) curves.push_back(task.curves);
  const auto page = read_page_data(directory / "sweep.json",
                                   [&](Json sweep) { return data_of(directory, std::move(sweep), curves); });
  write_text(directory / "report.html", sweep_page(page.title, page.json));
}

}  // namespace breccia
