#include "breccia/results/stored_study.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/printable.hpp"
#include "breccia/io/safe_name.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/results/response_file.hpp"
#include "breccia/results/stored_composite.hpp"
#include "breccia/results/sweep_result.hpp"
#include "breccia/tables/csv.hpp"

#include "best_tests.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& place, const std::string& reason) {
  throw FileError(fmt::format("{}: not as `breccia run` writes it{}", place, reason));
}

/// The test of a stage with this identity. Throws FileError, with the place that names it, where there is none.
TestResult& test_in(std::vector<StageFindings>& stages, const std::string& stage, const TestId& id,
                    const std::string& place) {
  for (auto& one : stages) {
    const auto found = std::ranges::find(one.tests, id, &TestResult::id);
    if (one.name == stage && found != one.tests.end()) return *found;
  }
  refuse(place, ": curves.csv has no such test");
}

/// What a row of a table of samples tells of its test; the table of extrapolated curves has no column of grids.
TestId id_of_row(const CsvTable& table, std::size_t row) {
  const auto load = table.has("load") ? value_named<Load>(table.text("load")[row]) : Load::shear;
  const auto boundary = value_named<Boundary>(table.text("boundary")[row]);
  const auto method = value_named<Method>(table.text("method")[row]);
  const auto grid = table.has("cells") ? grid_named(table.text("cells")[row]) : TestGrid::extrapolated();
  if (!load || !boundary || !method || !grid) refuse(table.location(row), "");
  return {*load, *boundary, *method, *grid};
}

void add_curves(const fs::path& directory, std::vector<StageFindings>& stages) {
  for (auto& curve : read_curves(directory)) {
    const auto stage = std::ranges::find(stages, curve.stage, &StageFindings::name);
    if (stage == stages.end()) refuse((directory / "curves.csv").string(), ": a stage that study.json has not");
    const TestResult empty{.id = curve.test};
    auto& test = stage->tests.emplace_back(empty);
    test.modulus = std::move(curve.modulus);
  }
}

void add_compliances(const fs::path& file, std::vector<StageFindings>& stages) {
  if (!fs::exists(file)) return;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& test = test_in(stages, table.text("stage")[row], id_of_row(table, row), table.location(row));
    test.compliance.push_back({table.numbers("time_s")[row], table.numbers("compliance_1_per_Pa")[row]});
  }
}

void add_half_bands(const fs::path& file, std::vector<StageFindings>& stages) {
  if (!fs::exists(file)) return;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& test = test_in(stages, table.text("stage")[row], id_of_row(table, row), table.location(row));
    test.half_bands.push_back(table.numbers("half_band_Pa")[row]);
  }
}

void add_comparisons(const fs::path& file, std::vector<StageFindings>& stages) {
  if (!fs::exists(file)) return;
  const auto table = read_csv(file, {"measurement", "stage", "boundary", "method", "cells"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto stage = std::ranges::find(stages, table.text("stage")[row], &StageFindings::name);
    if (stage == stages.end()) refuse(table.location(row), ": a stage that study.json has not");
    const auto id = id_of_row(table, row);
    const auto& measurement = table.text("measurement")[row];
    auto& all = stage->comparisons;
    if (all.empty() || all.back().measurement != measurement || all.back().test != id) {
      all.push_back({measurement, id, {}});
    }
    all.back().samples.push_back(
        {table.numbers("time_s")[row], table.numbers("modulus_Pa")[row], table.numbers("measured_Pa")[row]});
  }
}

void add_series(const fs::path& directory, std::vector<StageFindings>& stages) {
  const auto all = read_stored_series(directory);
  for (auto& stage : stages) {
    for (const auto* const preferred : best_tests(stage)) {
      const auto found = std::ranges::find_if(all, [&](const StageSeries& one) {
        return one.stage == stage.name && one.load == preferred->id.load && one.boundary == preferred->id.boundary;
      });
      if (found == all.end()) continue;
      std::ranges::find(stage.tests, preferred->id, &TestResult::id)->series = found->series;
    }
  }
}

/// Error and wall time of the computation of a test.
void read_record(const nlohmann::json& json, TestResult& test) {
  if (json.contains("error_estimate") && json["error_estimate"].is_number()) {
    test.error_estimate = json["error_estimate"].get<double>();
  }
  if (test.id.grid.is_extrapolated()) return;
  test.seconds = 0.0;
  if (test.id.method == Method::dynamic) {
    for (const auto& domain : json.at("time_domains")) *test.seconds += domain.at("wall_time_s").get<double>();
  } else {
    test.seconds = json.at("wall_time_s").get<double>();
  }
}

StageFindings findings_in(const nlohmann::json& json) {
  StageFindings stage;
  stage.name = json.at("name").get<std::string>();
  if (!is_safe_name(stage.name))
    throw FileError(fmt::format("\"{}\" is not a name that `breccia run` gives to a stage", printable(stage.name)));
  stage.dimensions = json.at("dimensions").get<int>();
  for (const auto& cells : json.at("cells")) {
    if (cells.is_number_integer()) stage.cells = std::max(stage.cells, cells.get<int>());
  }
  stage.points = json.at("points").get<std::size_t>();
  stage.point_fraction = json.at("filler_point_fraction").get<double>();
  stage.warnings = json.at("warnings").get<std::vector<std::string>>();
  return stage;
}

void read_records(const nlohmann::json& json, StageFindings& stage) {
  for (const auto& one : json.at("tests")) {
    const auto& cells = one.at("cells");
    const auto grid =
        grid_named(cells.is_number_integer() ? std::to_string(cells.get<long>()) : cells.get<std::string>());
    for (auto& test : stage.tests) {
      const bool is_it = name_of(test.id.load) == one.at("load") && name_of(test.id.boundary) == one.at("boundary") &&
                         name_of(test.id.method) == one.at("method") && grid == test.id.grid;
      if (is_it) read_record(one, test);
    }
  }
}

}  // namespace

StoredStudy read_stored_study(const fs::path& directory) {
  require_stored_study(directory);
  StoredStudy study{.content = read_stored_content(directory)};
  auto& stages = study.stages;
  const auto file = directory / "study.json";
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  try {
    if (json.at("wall_time_s").is_number()) study.seconds = json["wall_time_s"].get<double>();
    for (const auto& stage : json.at("stages")) stages.push_back(findings_in(stage));
    add_curves(directory, stages);
    for (std::size_t i = 0; i < stages.size(); ++i) read_records(json["stages"][i], stages[i]);
  } catch (const nlohmann::json::exception& error) {
    refuse(file.string(), fmt::format(": {}", error.what()));
  }
  add_compliances(directory / "compliance.csv", stages);
  add_half_bands(directory / "extrapolation.csv", stages);
  add_comparisons(directory / "comparison.csv", stages);
  add_series(directory, stages);
  for (const auto& stage : stages) {
    const auto responses = directory / stage.name / "response.h5";
    if (fs::exists(responses)) study.responses.push_back(read_responses(responses));
  }
  return study;
}

}  // namespace breccia
