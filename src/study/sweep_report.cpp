#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "breccia/io/text_file.hpp"
#include "breccia/report/page.hpp"
#include "breccia/study/report.hpp"

#include "report_data.hpp"
#include "sweep_results.hpp"

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
          {"load", curve.load},
          {"boundary", curve.boundary},
          {"method", curve.method},
          {"cells", curve.cells},
          {"time_s", rounded(std::move(times))},
          {"modulus_Pa", rounded(std::move(moduli))}};
}

/// Everything that the page shows, as it is on the disk.
Json data_of(const fs::path& directory, Json sweep) {
  Json curves = Json::array(), tables = Json::object();
  const auto& tasks = sweep.at("tasks");
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    if (tasks[task].at("state") != "done") continue;
    for (const auto& curve : read_curves(directory / tasks[task].at("name").get<std::string>())) {
      curves.push_back(json_of(task, curve));
    }
  }
  if (fs::exists(directory / "spread.csv")) tables["spread.csv"] = read_text(directory / "spread.csv");
  return {{"sweep", std::move(sweep)}, {"curves", std::move(curves)}, {"tables", std::move(tables)}};
}

}  // namespace

void write_sweep_report(const fs::path& directory) {
  write_page(directory, "sweep.json", sweep_page, [&](Json sweep) { return data_of(directory, std::move(sweep)); });
}

}  // namespace breccia
