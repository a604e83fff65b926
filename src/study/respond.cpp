#include "breccia/study/respond.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "results.hpp"
#include "stage_extrapolation.hpp"

namespace breccia {
namespace {

TestResult test_of(const StoredResponses::Entry& entry, const Material& matrix, const TimeWindow& window,
                   int points_per_decade) {
  const auto& [cells, response] = entry;
  QuasistaticRecord record;
  record.response.load = response.load;
  record.response.error_estimate = require_sampled(response, matrix, window);
  const auto compliance = creep_compliance(response, matrix);
  TestResult test{.load = response.load, .boundary = response.boundary, .method = Method::quasistatic, .cells = cells};
  test.series = relaxation_modulus(compliance);
  for (const double time : logarithmic_times(window, points_per_decade)) {
    test.modulus.push_back({time, test.series.at(time)});
    if (response.boundary == Boundary::traction) test.compliance.push_back({time, compliance.at(time)});
  }
  test.record = std::move(record);
  return test;
}

}  // namespace

StageResult respond(const StoredResponses& stored, const Material& matrix, std::optional<TimeWindow> times) {
  StageResult result;
  result.name = stored.stage;
  Stage stage;
  stage.name = stored.stage;
  stage.side = stored.side;
  std::vector<std::string> refusals;
  for (const auto& entry : stored.entries) {
    stage.cells = std::max(stage.cells, entry.cells);
    try {
      result.tests.push_back(test_of(entry, matrix, times.value_or(stored.times), stored.points_per_decade));
    } catch (const InputError& error) {
      const std::string refusal = error.what();
      if (std::ranges::find(refusals, refusal) == refusals.end()) refusals.push_back(refusal);
    }
  }
  if (!refusals.empty()) throw InputError(fmt::format("{}", fmt::join(refusals, "\n")));
  for (const auto& entry : stored.entries) {
    auto& coarser = stage.coarser_cells;
    if (entry.cells != stage.cells && std::ranges::find(coarser, entry.cells) == coarser.end()) {
      coarser.push_back(entry.cells);
    }
  }
  std::ranges::sort(stage.coarser_cells);
  std::ranges::stable_sort(result.tests, {}, &TestResult::cells);
  for (auto& test : extrapolate_tests(stage, result.tests)) result.tests.push_back(std::move(test));
  result.cells = stage.cells;
  return result;
}

void write_response_curves(const std::filesystem::path& directory, const std::vector<StageResult>& stages) {
  make_directory(directory);
  write_curves(directory, {stages});
}

}  // namespace breccia
