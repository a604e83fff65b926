#include "deck/chosen_boxes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "homogenisation/plan/box_choice.hpp"
#include "io/display.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

std::string percent(double share) {
  return fmt::format("{:.2g} %", 100.0 * share);
}

/// The parts of the error to be expected: "3.1 %, of the grid 2.1 %, of the packing 2.3 %".
std::string words_on_errors(const BoxChoice& choice) {
  const auto part = [](const std::optional<double>& error) { return error ? percent(*error) : "unknown"; };
  return fmt::format("{}of the grid {}, of the packing {}", choice.error() ? percent(*choice.error()) + ", " : "",
                     part(choice.grid), part(choice.sample));
}

/// The reason why a stage does not reach what was wanted of it, and what helps.
std::string words_on_miss(const BoxChoice& choice, double budget) {
  if (!choice.error()) {
    return fmt::format("the error to be expected is not known ({}), so that the {} chosen for what is known of it",
                       words_on_errors(choice), choice.particles > 0 ? "box and the grid were" : "grid was");
  }
  const auto expected =
      fmt::format("an error of up to {} is to be expected ({})", percent(*choice.error()), words_on_errors(choice));
  if (choice.seconds_of_goal) {
    return fmt::format("within {} and 8 GB {}; {} would take about {} and {} (tests.budget)", display_duration(budget),
                       expected, percent(choice.goal), display_duration(*choice.seconds_of_goal),
                       display(*choice.bytes_of_goal, "B"));
  }
  return choice.particles > 0 ? expected + "; no box and grid within reach gives less"
                              : expected + "; a larger box would have a smaller one";
}

bool names_cells(const Section& stage) {
  return stage.has("cells") || stage.has("resolution");
}

bool is_missing(const Stage& stage) {
  return !(stage.side > 0.0) || stage.cells == 0;
}

}  // namespace

std::optional<double> read_budget(const Section& deck, const Study& study) {
  const auto tests = deck.optional_section("tests");
  if (!tests) return std::nullopt;
  if (std::ranges::none_of(study.stages, is_missing)) {
    tests->refuse({"budget"}, "no box and no cells are left out that it could limit");
    return std::nullopt;
  }
  if (std::ranges::count(study.tests.methods, Method::dynamic) > 0) {
    tests->report("method", "box and cells are chosen for the quasi-static method alone; the dynamic one needs both");
  }
  return tests->optional_quantity("budget", Dimension::time, Range::positive());
}

void choose_missing_boxes(std::optional<double> budget, Study& study) {
  if (std::ranges::none_of(study.stages, is_missing)) return;
  AccuracyGoal goal;
  goal.seconds = budget.value_or(goal.seconds);
  goal.error = study.tests.accuracy.value_or(goal.error);
  study.tests.accuracy = goal.error;
  for (const auto& choice : choose_boxes(study, goal)) {
    if (choice.reaches_goal()) continue;
    study.provenance.warnings[choice.stage].push_back(
        fmt::format("accuracy {}: {}", percent(goal.error), words_on_miss(choice, goal.seconds)));
  }
}

std::string chosen_boxes(const Section& deck, const Study& study) {
  std::string text;
  const auto sections = deck.sections("stages");
  for (std::size_t number = 0; number < std::min(sections.size(), study.stages.size()); ++number) {
    const auto& stage = study.stages[number];
    if (stage.has_image()) continue;
    if (!sections[number].has("box")) text += fmt::format(" {:.17g}", stage.side);
    const bool needs_cells = model_of(study.tests, stage) == Model::cells;
    if (needs_cells && !names_cells(sections[number]))
      text += fmt::format(" {} {}", stage.cells, fmt::join(stage.coarser_cells, " "));
  }
  return text;
}

}  // namespace breccia
