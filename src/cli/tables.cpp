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
#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/quality.hpp"
#include "io/display.hpp"
#include "results/engineering_curves.hpp"
#include "study/abscissa_words.hpp"

namespace breccia::cli {
namespace {

/// The three header lines of a test's column: modulus, boundary, method.
std::array<std::string, 3> heading(const TestResult& test, int dimensions) {
  return {modulus_in_words(test.id.load, dimensions), name_of(test.id.boundary), name_of(test.id.method)};
}

/// Whether the error of Young's modulus is known at any time.
bool has_known_error_of_young(const EngineeringCurves& curves) {
  return std::ranges::any_of(curves.in_time, [](const auto& sample) { return sample.errors.young.has_value(); });
}

/// The moduli in shear and in bulk, and Young's modulus where both were tested.
std::string table_of(const StageResult& stage, const TimeWindow& times) {
  const auto shown = shown_tests(stage);
  if (shown.empty()) return {};
  const auto uniaxial = engineering_curves(stage, {});
  auto text = "\n" + stage.name;
  for (std::size_t line = 0; line < 3; ++line) {
    text += fmt::format("\n{:>12}", line == 2 ? "time" : "");
    for (const auto* test : shown) {
      text += fmt::format("  {:>12}", heading(*test, stage.dimensions)[line]);
      if (has_known_error(*test)) text += fmt::format("  {:>8}", line == 2 ? "error" : "");
    }
    for (const auto& curves : uniaxial) {
      const std::array heads = {std::string("E"), name_of(curves.test.boundary), name_of(curves.test.method)};
      text += fmt::format("  {:>12}", heads[line]);
      if (has_known_error_of_young(curves)) text += fmt::format("  {:>8}", line == 2 ? "error" : "");
    }
    text.erase(text.find_last_not_of(' ') + 1);
  }
  for (const double t : logarithmic_times(times, 1)) {
    text += fmt::format("\n{:>12}", display_time(t));
    for (const auto* test : shown) {
      text += fmt::format("  {:>12}", display(smoothed_at(test->modulus, t), "Pa"));
      if (has_known_error(*test)) text += fmt::format("  {:>8}", error_at(*test, t));
    }
    for (const auto& curves : uniaxial) {
      text += fmt::format("  {:>12}", display(curves.at_time(t).young, "Pa"));
      if (!has_known_error_of_young(curves)) continue;
      text += fmt::format("  {:>8}", error_text(curves.in_time[nearest_sample(curves.in_time, t)].errors.young));
    }
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

/// A line for each boundary and method with the thermal expansion of a stage at its first and last time after a step of
/// the temperature.
std::string lines_on_expansion(const StageResult& stage) {
  std::string text;
  for (const auto& [test, samples] : stage.expansions) {
    const auto at = [&](const ExpansionSample& sample) {
      const auto error = sample.error ? fmt::format(" +- {:.2g}e-6", 1e6 * *sample.error) : "";
      return fmt::format("{:.4g}e-6{} /K at {}", 1e6 * sample.expansion, error, display_time(sample.time));
    };
    const bool is_known = samples.front().error && samples.back().error;
    text += fmt::format("{}, {}, {}: linear thermal expansion {}, {}{}\n", stage.name, name_of(test.boundary),
                        name_of(test.method), at(samples.front()), at(samples.back()),
                        is_known ? "" : "; error unknown, as that of the bulk modulus is");
  }
  return text;
}

/// A line for each boundary with the anisotropy of a stage whose whole stiffness was asked for.
std::string lines_on_stiffness(const StageResult& stage, Abscissa abscissa) {
  std::string text;
  for (const auto& [test, samples] : stage.stiffness) {
    const auto at = [abscissa](const StiffnessSample& sample) {
      const auto index = isotropic_part(sample.constants).anisotropy;
      return fmt::format("{} at {}", index ? fmt::format("{:.2g}", *index) : "unknown",
                         display_in(abscissa, sample.time));
    };
    text += fmt::format("{}, {}: universal index of anisotropy {}, {}; the stiffness is in stiffness.csv\n", stage.name,
                        name_of(test.boundary), at(samples.front()), at(samples.back()));
  }
  return text;
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

std::string tables_of(const StageResult& stage, const TimeWindow& times, Abscissa abscissa) {
  return abscissa == Abscissa::frequency ? frequency_table_of(stage) : table_of(stage, times);
}

std::string closing_tables(const Study& study, const StudyResult& result, Detail detail) {
  const TimeWindow times = {study.tests.first_time, study.tests.last_time};
  std::string text, qualities;
  for (const auto i : shown_stages(study, result, detail)) {
    const auto& stage = result.stages[i];
    text += tables_of(stage, times, study.tests.abscissa());
    qualities += line_on_quality(study, study.stages[i], stage);
  }
  if (!qualities.empty()) text += "\n" + qualities;
  text += comparison_tables_of(result.stages, study.tests.abscissa());
  std::vector<std::vector<FillerStatistics>> fillers;
  for (const auto& stage : result.stages) fillers.push_back(stage.microstructure.fillers);
  auto remarks = filler_summary(study, fillers);
  for (const auto i : shown_stages(study, result, detail)) {
    remarks += lines_on_expansion(result.stages[i]) + lines_on_stiffness(result.stages[i], study.tests.abscissa());
  }
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
