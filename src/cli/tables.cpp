#include "cli/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "cli/comparison_tables.hpp"
#include "cli/filler_summary.hpp"
#include "cli/frequency_tables.hpp"
#include "cli/shown_tests.hpp"
#include "homogenisation/quality.hpp"
#include "io/display.hpp"

namespace breccia::cli {
namespace {

/// The three header lines of a test's column: modulus, boundary, method.
std::array<std::string, 3> heading(const TestResult& test, int dimensions) {
  return {modulus_in_words(test.id.load, dimensions), bound_of(test.id.boundary), name_of(test.id.method)};
}

std::string table_of(const StageResult& stage, const TimeWindow& times) {
  const auto shown = shown_tests(stage);
  if (shown.empty()) return {};
  auto text = "\n" + stage.name;
  for (std::size_t line = 0; line < 3; ++line) {
    text += fmt::format("\n{:>12}", line == 2 ? "time" : "");
    for (const auto* test : shown) {
      text += fmt::format("  {:>12}", heading(*test, stage.dimensions)[line]);
      if (has_known_error(*test)) text += fmt::format("  {:>8}", line == 2 ? "error" : "");
    }
    text.erase(text.find_last_not_of(' ') + 1);
  }
  for (const double t : logarithmic_times(times, 1)) {
    text += fmt::format("\n{:>12}", display_time(t));
    for (const auto* test : shown) {
      text += fmt::format("  {:>12}", display(smoothed_at(test->modulus, t), "Pa"));
      if (has_known_error(*test)) text += fmt::format("  {:>8}", error_at(*test, t));
    }
  }
  return text + "\n";
}

/// A line about the quality of the results for each stage with particles.
std::string words_on_quality(const Study& study, const StudyResult& result) {
  std::string text;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const auto quality = quality_of(study, study.stages[i], result.stages[i]);
    const auto summary = summary_of(quality);
    if (summary.empty()) continue;
    // The summary ends with the packing.
    text +=
        fmt::format("\n{}, this box: {}{}", result.stages[i].name, summary, quality.is_random ? " (--seeds 3)" : "");
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times, Abscissa abscissa) {
  if (abscissa == Abscissa::frequency) return frequency_tables_of(stages);
  std::string text;
  for (const auto& stage : stages) text += table_of(stage, times);
  return text;
}

std::string closing_tables(const Study& study, const StudyResult& result) {
  const TimeWindow times = {study.tests.first_time, study.tests.last_time};
  auto text = tables_of(result.stages, times, study.tests.abscissa());
  text += words_on_quality(study, result);
  text += comparison_tables_of(result.stages, study.tests.abscissa());
  std::vector<std::vector<FillerStatistics>> fillers;
  for (const auto& stage : result.stages) fillers.push_back(stage.microstructure.fillers);
  auto remarks = filler_summary(study, fillers);
  for (const auto& stage : result.stages) {
    // Some warnings were printed when the stage was packed, perhaps hours ago; they are repeated.
    for (const auto& warning : stage.warnings) remarks += "warning: " + warning + "\n";
    for (const auto& test : stage.tests) {
      const auto* dynamic = std::get_if<DynamicRecord>(&test.record);
      if (dynamic == nullptr || dynamic->overlaps.empty()) continue;
      double worst = 0.0;
      for (const auto& overlap : dynamic->overlaps) worst = std::max(worst, overlap.mismatch);
      remarks += fmt::format("{} {}, {}: {} time domains, worst mismatch where they overlap {:.2f} %\n", stage.name,
                             name_of(test.id.load), bound_of(test.id.boundary), dynamic->domains.size(), 100.0 * worst);
    }
  }
  if (!remarks.empty()) text += "\n" + remarks;
  return text;
}

}  // namespace breccia::cli
