#include "narration.hpp"

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/io/units.hpp"

#include "interruption.hpp"

namespace breccia::cli {
namespace {

std::string time(double value) {
  return fmt::format("{:.3g} s", value);
}

std::string describe(const StageResult& stage) {
  const auto& packed = stage.microstructure;
  auto text = fmt::format("{}: {} particles fill {:.2f} % of the box ({:.2f} % of {} points)", stage.name,
                          packed.microstructure.discs.size(), 100.0 * packed.fraction, 100.0 * stage.point_fraction,
                          stage.points);
  if (packed.events > 0) text += fmt::format(", packed in {:.2g} s", packed.seconds);
  for (const auto& warning : packed.warnings) text += "\nwarning: " + warning;
  return text;
}

/// A line on a quasi-static test; time domains have told of themselves.
std::string describe(const Stage& stage, const TestResult& test) {
  const auto* record = std::get_if<QuasistaticRecord>(&test.record);
  if (record == nullptr) return {};
  const auto& [response, effort, seconds] = *record;
  const auto how = response.reduced ? fmt::format("{} snapshots", response.reduced->snapshots.size())
                                    : fmt::format("{} solves", effort.solves);
  return fmt::format("{} {}, {}: {} cells, {}, {:.2g} s for all loads, {} about {:.1g} %", stage.name,
                     name_of(test.load), bound_of(test.boundary), test.cells, how, seconds,
                     response.reduced ? "error of the basis" : "error of the steps", 100.0 * response.error_estimate);
}

/// Those that a table shows: of several grids their limit alone.
std::vector<const TestResult*> shown_tests(const StageResult& stage) {
  const bool has_limits = std::ranges::any_of(stage.tests, [](const TestResult& test) { return test.cells == 0; });
  std::vector<const TestResult*> shown;
  for (const auto& test : stage.tests) {
    if (!has_limits || test.cells == 0) shown.push_back(&test);
  }
  return shown;
}

/// In the order of the table: what, under which boundary, by which method.
std::array<std::string, 3> heading(const StageResult& stage, const TestResult& test) {
  return {fmt::format("{} {}", stage.name, test.load == Load::bulk ? "K + G/3" : "G"), bound_of(test.boundary),
          name_of(test.method)};
}

}  // namespace

StudyObserver narrate(Progress& progress) {
  StudyObserver observer;
  observer.packing = [&progress](const Stage& stage, const PackingProgress& packing) {
    progress.update(stage.name + ": packing", packing.fraction / packing.fraction_to_reach,
                    fmt::format("{} events", packing.events));
    return !interruption_requested();
  };
  observer.packed = [&progress](const StageResult& stage) { progress.print(describe(stage)); };
  observer.progress = [&progress](const Stage& stage, const std::string& test, double share,
                                  const std::string& details) {
    progress.update(fmt::format("{} {}", stage.name, test), share, details);
    stop_if_interrupted();
  };
  observer.finished = [&progress](const Stage& stage, const TestResult& test) {
    if (const auto line = describe(stage, test); !line.empty()) progress.print(line);
  };
  observer.domain_finished = [&progress](const Stage& stage, Boundary boundary, Load load, const TimeDomain& domain) {
    const auto points = 4 * static_cast<std::size_t>(stage.cells) * static_cast<std::size_t>(stage.cells);
    progress.print(fmt::format(
        "{} {}, {}: density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps, {} terms, {:.1f} s, {:.0f} million "
        "points x steps/s",
        stage.name, name_of(load), bound_of(boundary), domain.density_factor, domain.window.begin, domain.window.end,
        domain.steps, domain.terms, domain.seconds, domain.point_steps_per_second(points) / 1e6));
  };
  return observer;
}

std::string table_of(const std::vector<StageResult>& stages, const TimeWindow& times) {
  std::string text;
  for (std::size_t line = 0; line < 3; ++line) {
    text += fmt::format("\n{:>16}", line == 2 ? "time" : "");
    for (const auto& stage : stages) {
      for (const auto* test : shown_tests(stage)) text += fmt::format("  {:>14}", heading(stage, *test)[line]);
    }
  }
  for (const double t : logarithmic_times(times, 1)) {
    text += fmt::format("\n{:>16}", time(t));
    for (const auto& stage : stages) {
      for (const auto* test : shown_tests(stage)) {
        text += fmt::format("  {:>14}", readable(smoothed_at(test->modulus, t), Dimension::pressure));
      }
    }
  }
  return text + "\n";
}

std::string closing_table(const Study& study, const StudyResult& result) {
  auto text = table_of(result.stages, {study.tests.first_time, study.tests.last_time});
  for (const auto& stage : result.stages) {
    // Those of the particles have been told when they were packed.
    for (std::size_t i = stage.microstructure.warnings.size(); i < stage.warnings.size(); ++i) {
      text += "\nwarning: " + stage.warnings[i];
    }
    for (const auto& test : stage.tests) {
      const auto* dynamic = std::get_if<DynamicTestResult>(&test.record);
      if (dynamic == nullptr || dynamic->overlaps.empty()) continue;
      double worst = 0.0;
      for (const auto& overlap : dynamic->overlaps) worst = std::max(worst, overlap.mismatch);
      text += fmt::format("\n{} {}, {}: {} time domains, worst mismatch where they overlap {:.2f} %", stage.name,
                          name_of(test.load), bound_of(test.boundary), dynamic->domains.size(), 100.0 * worst);
    }
  }
  return text;
}

}  // namespace breccia::cli
