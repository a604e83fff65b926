#include "cli/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "cli/filler_summary.hpp"
#include "cli/frequency_tables.hpp"
#include "cli/shown_tests.hpp"
#include "homogenisation/quality.hpp"
#include "io/display.hpp"

namespace breccia::cli {
namespace {

/// The three header lines of a test's column: modulus, boundary, method.
std::array<std::string, 3> heading(const TestResult& test, int dimensions) {
  return {modulus_in_words(test.id.load, dimensions), name_of(test.id.boundary), name_of(test.id.method)};
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

/// A table of the ratios of all computed moduli to one measurement, at whole decades.
std::string table_of(const std::string& measurement, const StageResult& stage) {
  std::vector<const Comparison*> compared;
  TimeWindow times = {std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& comparison : stage.comparisons) {
    if (comparison.measurement != measurement) continue;
    compared.push_back(&comparison);
    times.begin = std::min(times.begin, comparison.samples.front().time);
    times.end = std::max(times.end, comparison.samples.back().time);
  }
  auto text = fmt::format("\n{} over what was measured, {}\n{:>12}", stage.name, measurement, "");
  for (const auto* comparison : compared) text += fmt::format("  {:>12}", name_of(comparison->test.boundary));
  text += fmt::format("\n{:>12}", "time");
  for (const auto* comparison : compared) text += fmt::format("  {:>12}", name_of(comparison->test.method));
  text += fmt::format("  {:>12}", "measured");
  for (const double t : logarithmic_times(times, 1)) {
    text += fmt::format("\n{:>12}", display_time(t));
    double measured = 0.0;
    for (const auto* comparison : compared) {
      const auto at = std::ranges::find_if(
          comparison->samples, [t](const ComparedSample& sample) { return std::abs(sample.time / t - 1.0) < 1e-6; });
      const bool is_known = at != comparison->samples.end();
      if (is_known) measured = at->measured;
      text += fmt::format("  {:>12}", is_known ? fmt::format("{:.3f}", at->ratio()) : "");
    }
    if (measured > 0.0) text += fmt::format("  {:>12}", display(measured, "Pa"));
  }
  for (const auto* comparison : compared) {
    const auto &best = comparison->best(), &worst = comparison->worst();
    text += fmt::format("\n  {}, {}: nearest {:.3f} at {}, furthest {:.3f} at {}", name_of(comparison->test.boundary),
                        name_of(comparison->test.method), best.ratio(), display_time(best.time), worst.ratio(),
                        display_time(worst.time));
  }
  return text + "\n";
}

/// Whether another stage builds upon a stage.
bool is_matrix(const Study& study, const std::string& stage) {
  return std::ranges::any_of(study.stages, [&stage](const Stage& other) {
    const auto* earlier = std::get_if<EarlierStage>(&other.matrix);
    return earlier != nullptr && earlier->name == stage;
  });
}

/// The stages that the tables show, by their numbers.
std::vector<std::size_t> shown_stages(const Study& study, const StudyResult& result, Detail detail) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    if (detail == Detail::full || !is_matrix(study, study.stages[i].name)) shown.push_back(i);
  }
  return shown;
}

/// A line about the quality of a stage's results; empty for a box without particles.
std::string line_on_quality(const Study& study, const Stage& stage, const StageResult& result) {
  const auto quality = quality_of(study, stage, result);
  const auto summary = summary_of(quality);
  if (summary.empty()) return {};
  // The summary ends with the packing.
  return fmt::format("{}, this box: {}{}\n", stage.name, summary, quality.is_random ? " (--seeds 3)" : "");
}

}  // namespace

std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times) {
  std::string text;
  for (const auto& stage : stages) text += table_of(stage, times);
  return text;
}

std::string closing_tables(const Study& study, const StudyResult& result, Detail detail) {
  const TimeWindow times = {study.tests.first_time, study.tests.last_time};
  std::string text, qualities;
  for (const auto i : shown_stages(study, result, detail)) {
    const auto& stage = result.stages[i];
    text += study.tests.by_frequency ? frequency_table_of(stage) : table_of(stage, times);
    qualities += line_on_quality(study, study.stages[i], stage);
  }
  if (!qualities.empty()) text += "\n" + qualities;
  for (const auto& measurement : study.measurements) {
    const auto stage = std::ranges::find(result.stages, measurement.stage, &StageResult::name);
    const bool is_compared = std::ranges::any_of(
        stage->comparisons, [&](const Comparison& one) { return one.measurement == measurement.label; });
    if (is_compared) text += table_of(measurement.label, *stage);
  }
  std::vector<std::vector<FillerStatistics>> fillers;
  for (const auto& stage : result.stages) fillers.push_back(stage.microstructure.fillers);
  auto remarks = filler_summary(study, fillers);
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      const auto* dynamic = std::get_if<DynamicRecord>(&test.record);
      if (dynamic == nullptr || dynamic->overlaps.empty()) continue;
      double worst = 0.0;
      for (const auto& overlap : dynamic->overlaps) worst = std::max(worst, overlap.mismatch);
      remarks += fmt::format("{} {}, {}: {} time domains, worst mismatch where they overlap {:.2f} %\n", stage.name,
                             name_of(test.id.load), name_of(test.id.boundary), dynamic->domains.size(), 100.0 * worst);
    }
  }
  if (!remarks.empty()) text += "\n" + remarks;
  return text;
}

}  // namespace breccia::cli
