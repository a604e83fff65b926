#include "narration.hpp"

#include <cmath>

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

}  // namespace

StudyObserver narrate(Progress& progress) {
  StudyObserver observer;
  observer.packing = [&progress](const Stage& stage, const PackingProgress& packing) {
    progress.update(stage.name + ": packing", packing.fraction / packing.fraction_to_reach,
                    fmt::format("{} events", packing.events));
    return !interruption_requested();
  };
  observer.packed = [&progress](const StageResult& stage) { progress.print(describe(stage)); };
  observer.progress = [&progress](const Stage& stage, Load load, const DynamicProgress& running) {
    progress.update(fmt::format("{} {}", stage.name, name_of(load)), running.share,
                    fmt::format("time domain {} at {}, {:.0f} million points x steps/s", running.domain + 1,
                                time(running.time), running.point_steps_per_second / 1e6));
    stop_if_interrupted();
  };
  observer.domain_finished = [&progress](const Stage& stage, Load load, const TimeDomain& domain) {
    const auto points = 4 * static_cast<std::size_t>(stage.cells) * static_cast<std::size_t>(stage.cells);
    progress.print(
        fmt::format("{} {}: density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps, {} terms, {:.1f} s, {:.0f} million "
                    "points x steps/s",
                    stage.name, name_of(load), domain.density_factor, domain.window.begin, domain.window.end,
                    domain.steps, domain.terms, domain.seconds, domain.point_steps_per_second(points) / 1e6));
  };
  return observer;
}

std::string closing_table(const Study& study, const StudyResult& result) {
  std::string text = "\n            time";
  for (const auto& stage : result.stages) {
    for (const auto& test : stage.tests) {
      text += fmt::format("  {:>18}", fmt::format("{} {}", stage.name, test.load == Load::bulk ? "K + G/3" : "G"));
    }
  }
  for (const double t : logarithmic_times({study.tests.first_time, study.tests.last_time}, 1)) {
    text += fmt::format("\n{:>16}", time(t));
    for (const auto& stage : result.stages) {
      for (const auto& test : stage.tests) {
        const auto& curve = test.dynamic.curve;
        text += fmt::format("  {:>18}", readable(smoothed_at(curve, t), Dimension::pressure));
      }
    }
  }
  text += "\n";
  for (const auto& stage : result.stages) {
    // Those of the particles have been told when they were packed.
    for (std::size_t i = stage.microstructure.warnings.size(); i < stage.warnings.size(); ++i) {
      text += "\nwarning: " + stage.warnings[i];
    }
    for (const auto& test : stage.tests) {
      double worst = 0.0;
      for (const auto& overlap : test.dynamic.overlaps) worst = std::max(worst, overlap.mismatch);
      if (!test.dynamic.overlaps.empty()) {
        text += fmt::format("\n{} {}: {} time domains, worst mismatch where they overlap {:.2f} %", stage.name,
                            name_of(test.load), test.dynamic.domains.size(), 100.0 * worst);
      }
    }
  }
  return text;
}

}  // namespace breccia::cli
