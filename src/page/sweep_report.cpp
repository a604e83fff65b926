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

Json json_of(std::size_t task, const TaskCurve& curve) {
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : curve.modulus) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  return {{"task", task},
          {"stage", curve.stage},
          {"load", name_of(curve.test.load)},
          {"boundary", name_of(curve.test.boundary)},
          {"method", name_of(curve.test.method)},
          {"cells", name_of(curve.test.grid)},
          {"time_s", rounded(std::move(times))},
          {"modulus_Pa", rounded(std::move(moduli))}};
}

/// The curves of each finished task, from its files.
std::vector<std::vector<TaskCurve>> stored_curves(const fs::path& directory, const Json& tasks) {
  std::vector<std::vector<TaskCurve>> curves(tasks.size());
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    if (tasks[task].at("state") != "done") continue;
    const auto name = tasks[task].at("name").get<std::string>();
    if (!stays_in_directory(name)) {
      throw FileError(fmt::format("sweep.json: \"{}\" is not a name that `breccia run` gives to a task", name));
    }
    curves[task] = read_curves(directory / name);
  }
  return curves;
}

/// The measurements that the finished tasks are compared with, each of them once for a stage.
Json measurements_of(const fs::path& directory, const Json& tasks) {
  Json measurements = Json::array();
  std::set<std::pair<std::string, std::string>> known;
  for (const auto& task : tasks) {
    if (task.at("state") != "done") continue;
    const auto file = directory / task.at("name").get<std::string>() / "comparison.csv";
    if (!is_there(file)) continue;
    const auto table = read_csv(file, {"measurement", "stage", "boundary", "method", "cells"});
    std::map<std::pair<std::string, std::string>, std::map<double, double>> measured;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      measured[{table.text("stage")[row], table.text("measurement")[row]}][table.numbers("time_s")[row]] =
          table.numbers("measured_Pa")[row];
    }
    for (const auto& [name, values] : measured) {
      if (!known.insert(name).second) continue;
      std::vector<double> times, moduli;
      for (const auto& [time, modulus] : values) {
        times.push_back(time);
        moduli.push_back(modulus);
      }
      measurements.push_back({{"stage", name.first},
                              {"measurement", name.second},
                              {"time_s", rounded(std::move(times))},
                              {"measured_Pa", rounded(std::move(moduli))}});
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
  auto spread = table_for_page(directory / "spread.csv", text_columns);
  if (!spread.empty()) tables["spread.csv"] = std::move(spread);
  auto measurements = measurements_of(directory, sweep.at("tasks"));
  return {{"sweep", std::move(sweep)},
          {"curves", std::move(curves)},
          {"tables", std::move(tables)},
          {"measurements", std::move(measurements)}};
}

}  // namespace

PageData sweep_page_data(const fs::path& directory) {
  return read_page_data(directory / "sweep.json", [&](Json sweep) {
    const auto curves = stored_curves(directory, sweep.at("tasks"));
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
