#include "cli/narration.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "cli/interruption.hpp"
#include "cli/sweep_summary.hpp"
#include "homogenisation/crystal_words.hpp"
#include "homogenisation/debonding_words.hpp"
#include "io/display.hpp"
#include "io/units.hpp"
#include "parallel/session.hpp"
#include "study/gap.hpp"
#include "study/picture_words.hpp"

namespace breccia::cli {
namespace {

/// The content of a box in words: "40 particles", "25 grains", "pixels of the filler".
struct InclusionsInWords {
  const Stage& stage;

  template <int dim>
  std::string operator()(const SharedImage<dim>&) const {
    return fmt::format("{} of the filler{}", name_of_pixels(dim), stage.fillers.size() > 1 ? "s" : "");
  }
  template <int dim>
  std::string operator()(const Grains<dim>& grains) const {
    return fmt::format("{} grains", grains.statistics.count);
  }
  template <class Particles>
  std::string operator()(const Particles& box) const {
    return fmt::format("{} particles", box.particles.size());
  }
};

/// A time that a calculation has taken: "2.4 s", "140 s".
std::string seconds_in_words(double seconds) {
  constexpr double many = 99.5;
  return seconds < many ? fmt::format("{:.2g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

std::string describe(const Stage& stage, const StageResult& result) {
  const auto& packed = result.microstructure;
  const bool has_points = result.points > 0;
  auto text = fmt::format("{}: {} fill {:.2f} % of the box", stage.name,
                          visit_nested(InclusionsInWords{stage}, packed.box), 100.0 * packed.fraction);
  if (has_points) text += fmt::format(" ({:.2f} % of {} points)", 100.0 * result.point_fraction, result.points);
  if (packed.events > 0)
    text += fmt::format(", gap {}, packed in {}", gaps_in_words(stage), seconds_in_words(packed.seconds));
  if (const auto* grains = packed.grains()) {
    text += fmt::format(", films of {}", readable(grains->film, Dimension::length));
    if (has_points) text += fmt::format(" ({:.2g} cells)", grains->film / stage.cell_size());
    if (stage.bonds) text += "\n  " + words_on_debonding(stage, *grains);
  }
  for (const auto& line : words_on_crystals(stage)) text += "\n  " + line;
  if (stage.fillers.size() > 1) {
    for (std::size_t number = 0; number < packed.fillers.size(); ++number) {
      const auto& own = packed.fillers[number];
      const auto particles = stage.has_image() ? std::string(name_of_pixels(stage.dimensions()))
                                               : fmt::format("{} particles", own.particles);
      text += fmt::format("\n  filler {}, {}: {} fill {:.2f} %", number, stage.fillers[number].material.name, particles,
                          100.0 * own.fraction);
    }
  }
  for (const auto& line : words_on_threshold(stage)) text += "\n  " + line;
  return text;
}

/// The shear moduli of a phase in the snapshots: "matrix from 1 MPa to 300 MPa".
std::string describe_snapshots(const ReducedResponse& response, std::size_t phase) {
  const auto shear_of = [phase](const Snapshot& one) { return one.moduli[phase].shear; };
  const auto [softest, stiffest] = std::ranges::minmax(response.snapshots, {}, shear_of);
  return fmt::format("{} from {} to {}", response.phases()[phase], display(shear_of(softest), "Pa"),
                     display(shear_of(stiffest), "Pa"));
}

/// The error of the method in time, in words, and the moduli to which it applies.
std::string describe_error(double error_estimate, const std::optional<ReducedResponse>& reduced) {
  const double per_cent = 100.0 * error_estimate;
  if (!reduced) return fmt::format("error of the steps about {:.1g} %", per_cent);
  std::vector<std::string> phases;
  for (std::size_t phase = 0; phase < reduced->phases().size(); ++phase) {
    phases.push_back(describe_snapshots(*reduced, phase));
  }
  return fmt::format("error of the basis (at Laplace variables, {}) about {:.1g} %", fmt::join(phases, ", "), per_cent);
}

// The line that reports an event to the user; empty where there is none.

std::string line_of(const DomainFinished& event) {
  const auto& domain = event.domain;
  const auto points = point_count(event.stage, event.test.grid.cells().value());
  return fmt::format(
      "{} {}, {}: density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps, {}, {:.1f} s, {:.0f} million "
      "points x steps/s",
      event.stage.name, name_of(event.test.load), name_of(event.test.boundary), domain.mass_scaling,
      domain.window.begin, domain.window.end, domain.steps, display_count(domain.terms, "term"), domain.seconds,
      domain.point_steps_per_second(points) / 1e6);
}

/// Whether a test is of the same quasi-static calculation as an earlier one, under another load.
bool is_of_earlier_calculation(std::span<const TestResult> tests, const TestId& id) {
  const auto is_same = [&id](const TestResult& other) {
    return other.id.boundary == id.boundary && other.id.grid == id.grid && other.id.method == id.method;
  };
  return std::ranges::any_of(tests.first(tests.size() - 1), is_same);
}

/// The line about a quasi-static test. Dynamic tests have a line for each time domain instead.
std::string line_of(const TestFinished& event, Detail detail) {
  const auto& tests = event.result.stages.back().tests;
  const auto& test = tests.back();
  const auto* record = std::get_if<QuasistaticRecord>(&test.record);
  if (record == nullptr) return {};
  const auto how = record->reduced ? fmt::format("{} snapshots", record->reduced->snapshots.size())
                                   : fmt::format("{} solves", record->effort.solves);
  const auto seconds = test.seconds.value_or(0.0);
  if (detail == Detail::brief) {
    if (is_of_earlier_calculation(tests, test.id)) return {};
    return fmt::format("{}, {}: {}, {}, {}", event.stage.name, name_of(test.id.boundary), words_of(test.id.grid), how,
                       seconds_in_words(seconds));
  }
  return fmt::format("{} {}, {}: {}, {}, {} for all loads, {}", event.stage.name, name_of(test.id.load),
                     name_of(test.id.boundary), words_of(test.id.grid), how, seconds_in_words(seconds),
                     describe_error(test.error_estimate, record->reduced));
}

std::string line_of(const ResultsKeptBeside& event) {
  return fmt::format("The earlier results are kept until the new ones, in {}, are complete", event.directory.string());
}

std::string line_of(const StageTakenOver& event) {
  return fmt::format("{}: the same as in {}", event.stage.name, event.directory.string());
}

std::string line_of(const StageFromResponses& event) {
  return fmt::format("{}: computed from the reduced responses of task {}, at another temperature, without field maps",
                     event.stage.name, event.task);
}

std::string line_of(const TaskBegun& event) {
  return heading_of(event.sweep, event.task);
}

std::string line_of(const TaskSkipped& event) {
  return fmt::format("{}, complete already", heading_of(event.sweep, event.task));
}

std::string line_of(const TaskFailed& event) {
  return fmt::format("{} has failed: {}", heading_of(event.sweep, event.task), event.error);
}

/// Prints the line of an event. All processes of a group are sent the same notes, which are printed even if the
/// progress is not.
struct PrintEvent {
  ProgressLine& line;
  Detail detail;

  void operator()(const Note& note) const {
    if (parallel::rank() == 0) line.note(note.text);
  }
  void operator()(const StagePacked& event) const {
    const auto& stage = event.result.stages.back();
    line.print(describe(event.stage, stage));
    warn(stage);
  }
  /// Warnings of the tests come after those of the packing.
  void operator()(const StageFinished& event) const { warn(event.result.stages.back()); }
  void operator()(const TestFinished& event) const {
    if (const auto text = line_of(event, detail); !text.empty()) line.print(text);
  }
  template <class Event>
  void operator()(const Event& event) const {
    if (const auto text = line_of(event); !text.empty()) line.print(text);
  }

 private:
  /// Prints the warnings of a stage, each once.
  void warn(const StageResult& stage) const {
    if (!parallel::is_first()) return;
    for (const auto& warning : stage.warnings) line.warn(warning);
  }
};

}  // namespace

RunObserver narrate(ProgressLine& line, Detail detail) {
  return {.progress = [&line](const Progress& now) { line.update(now.what, now.share, now.details); },
          .event =
              [&line, detail](const RunEvent& event) {
                if (std::holds_alternative<TaskBegun>(event)) stop_if_interrupted();
                std::visit(PrintEvent{line, detail}, event);
              }};
}

}  // namespace breccia::cli
