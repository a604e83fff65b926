#include "results/stored_study.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/complex_moduli.hpp"
#include "results/best_tests.hpp"
#include "results/error_file.hpp"
#include "results/expansion_file.hpp"
#include "results/stiffness_file.hpp"
#include "results/stored_comparisons.hpp"
#include "results/stored_composite.hpp"
#include "results/stored_document.hpp"
#include "results/stored_responses.hpp"
#include "results/sweep_result.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& place, const std::string& reason) {
  throw FileError(fmt::format("{}: not as `breccia run` writes it{}", place, reason));
}

/// The test of a stage with this identity. Throws FileError, with the location that names the test, where there is
/// none.
TestResult& test_in(std::vector<StageFindings>& stages, const std::string& stage, const TestId& id,
                    const std::string& place) {
  for (auto& one : stages) {
    const auto found = std::ranges::find(one.tests, id, &TestResult::id);
    if (one.name == stage && found != one.tests.end()) return *found;
  }
  refuse(place, ": curves.csv has no such test");
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

void add_errors(const fs::path& file, std::vector<StageFindings>& stages) {
  if (!fs::exists(file)) return;
  const auto table = read_error_table(file);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& test = test_in(stages, table.text("stage")[row], id_of_row(table, row), table.location(row));
    test.errors.push_back(error_in(table, row));
  }
  for (const auto& stage : stages) {
    for (const auto& test : stage.tests) {
      const bool is_complete = test.errors.empty() || test.errors.size() == test.modulus.size();
      if (!is_complete) refuse(file.string(), ": not an error for each row of curves.csv");
    }
  }
}

void add_comparisons(const fs::path& directory, std::vector<StageFindings>& stages) {
  for (auto& [name, comparisons] : read_comparisons(directory)) {
    const auto stage = std::ranges::find(stages, name, &StageFindings::name);
    if (stage == stages.end()) refuse(directory.string(), ": a comparison of a stage that study.json has not");
    stage->comparisons = std::move(comparisons);
  }
}

void add_expansions(const fs::path& directory, std::vector<StageFindings>& stages) {
  for (auto& [name, expansions] : read_expansions(directory / "thermal_expansion.csv")) {
    const auto stage = std::ranges::find(stages, name, &StageFindings::name);
    if (stage == stages.end()) refuse(directory.string(), ": a thermal expansion of a stage that study.json has not");
    stage->expansions = std::move(expansions);
  }
}

void add_stiffness(const fs::path& directory, std::vector<StageFindings>& stages) {
  for (auto& [name, stiffness] : read_stiffness(directory / stiffness_file)) {
    const auto stage = std::ranges::find(stages, name, &StageFindings::name);
    if (stage == stages.end()) refuse(directory.string(), ": a stiffness of a stage that study.json has not");
    stage->stiffness = std::move(stiffness);
  }
}

/// The complex moduli of a study whose deck gives frequencies.
void add_dynamic_curves(const fs::path& file, std::vector<StageFindings>& stages) {
  if (!fs::exists(file)) return;
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells", "error"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& test = test_in(stages, table.text("stage")[row], id_of_row(table, row), table.location(row));
    const double omega = table.numbers("angular_frequency_rad_per_s")[row];
    test.in_frequency.push_back({omega, table.numbers("storage_modulus_Pa")[row], table.numbers("loss_modulus_Pa")[row],
                                 whole_error_at(test, 1.0 / omega)});
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

/// Takes the error and the wall time of the computation of a test from its record.
struct TakeRecord {
  TestResult& test;

  void operator()(std::monostate /*unknown*/) const {}
  void operator()(const ExtrapolationRecord& /*record*/) const {}
  void operator()(const MeanEntry& record) const {
    test.record = MeanRecord{record.loads};
    test.error_estimate = record.error_estimate.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  void operator()(const QuasistaticEntry& record) const {
    test.error_estimate = record.error_estimate.value_or(std::numeric_limits<double>::quiet_NaN());
    test.seconds = record.seconds;
  }
  void operator()(const DynamicEntry& record) const {
    test.seconds = 0.0;
    for (const auto& domain : record.domains) *test.seconds += domain.seconds;
  }
};

void add_records(const StageEntry& entry, StageFindings& stage) {
  for (const auto& one : entry.tests) {
    const auto test = std::ranges::find(stage.tests, one.id, &TestResult::id);
    if (test != stage.tests.end()) std::visit(TakeRecord{*test}, one.record);
  }
}

StageFindings findings_of(const StageEntry& entry) {
  StageFindings stage;
  stage.name = entry.name;
  stage.dimensions = entry.dimensions;
  stage.points = entry.points;
  stage.point_fraction = entry.point_fraction;
  stage.warnings = entry.warnings;
  const auto& quality = entry.quality;
  stage.accuracy = {quality.summary, quality.grid_error, rules_in(quality)};
  for (const auto& grid : entry.grids) stage.cells = std::max(stage.cells, grid.cells().value_or(0));
  return stage;
}

}  // namespace

StoredStudy read_stored_study(const fs::path& directory) {
  require_stored_study(directory);
  const auto document = read_study_document(directory);
  StoredStudy study{.content = content_of(document), .seconds = document.seconds};
  auto& stages = study.stages;
  for (const auto& stage : document.stages) stages.push_back(findings_of(stage));
  add_curves(directory, stages);
  for (std::size_t i = 0; i < stages.size(); ++i) add_records(document.stages[i], stages[i]);
  add_compliances(directory / "compliance.csv", stages);
  add_half_bands(directory / "extrapolation.csv", stages);
  add_errors(directory / "errors.csv", stages);
  add_comparisons(directory, stages);
  add_expansions(directory, stages);
  add_stiffness(directory, stages);
  if (document.frequencies) add_dynamic_curves(directory / "dynamic.csv", stages);
  add_series(directory, stages);
  study.responses = read_stored_responses(directory, document);
  return study;
}

}  // namespace breccia
