#include "deck/chosen_boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "deck/stages.hpp"
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

/// The limits of a choice: "within 10 min and 8 GB".
std::string words_on_limits(const BoxChoice& choice) {
  return fmt::format("within {} and {}", display_duration(choice.budget), display(most_bytes_of_choice, "B"));
}

/// What the accuracy that was wanted of a stage would take, and the key that allows for it.
std::string words_on_needs(const BoxChoice& choice) {
  const bool lacks_memory = *choice.bytes_of_goal > most_bytes_of_choice;
  return fmt::format("{} would take about {} and {}{}", percent(choice.goal), display_duration(*choice.seconds_of_goal),
                     display(*choice.bytes_of_goal, "B"), lacks_memory ? "" : " (tests.budget)");
}

/// The reason why a stage does not reach what was wanted of it, and what helps.
std::string words_on_miss(const BoxChoice& choice) {
  const bool is_over = choice.seconds > choice.budget;
  const auto costs = is_over ? fmt::format("; it takes about {}", display_duration(choice.seconds)) : std::string();
  if (!choice.error()) {
    return fmt::format("the error to be expected is not known ({}), so that the {} chosen for what is known of it{}",
                       words_on_errors(choice), choice.particles > 0 ? "box and the grid were" : "grid was", costs);
  }
  const auto expected = fmt::format("an error of up to {} is to be expected ({}){}", percent(*choice.error()),
                                    words_on_errors(choice), costs);
  if (choice.seconds_of_goal) {
    return fmt::format("{} {}; {}", words_on_limits(choice), expected, words_on_needs(choice));
  }
  return choice.particles > 0 ? fmt::format("{} {}", words_on_limits(choice), expected)
                              : expected + "; a larger box would have a smaller one of the packing";
}

/// The accuracy [-] that films of the plane reach with their default elements (theory, Eq. 66b).
constexpr double accuracy_of_default_films = 0.05;

/// Gives films of the plane elements of half the default length, unless the deck names a length.
void refine_films(const Section& deck, Study& study) {
  const bool is_in_the_plane = std::ranges::all_of(study.stages, [](const Stage& s) { return s.dimensions() == 2; });
  if (study.tests.model != Model::films || !is_in_the_plane || study.tests.films.layers) return;
  const auto tests = deck.optional_section("tests");
  const auto films = tests ? tests->optional_section("films") : std::nullopt;
  if (!films || !films->has("face_share")) study.tests.films.face_share *= 0.5;
}

}  // namespace

std::optional<double> read_budget(const Section& deck, const Study& study) {
  const auto tests = deck.optional_section("tests");
  if (!tests) return std::nullopt;
  if (std::ranges::none_of(study.stages, needs_choice)) {
    tests->refuse({"budget"}, "no box and no cells are left out that it could limit");
    return std::nullopt;
  }
  return tests->optional_quantity("budget", Dimension::time, Range::positive());
}

void choose_missing_boxes(const Section& deck, std::optional<double> budget, Study& study) {
  if (std::ranges::none_of(study.stages, needs_choice)) return;
  if (std::ranges::count(study.tests.methods, Method::dynamic) > 0) {
    deck.section("tests").report(
        "method", "box and cells are chosen for the quasi-static method alone; the dynamic one needs both");
    return;
  }
  AccuracyGoal goal;
  goal.seconds = budget.value_or(goal.seconds);
  goal.error = study.tests.accuracy.value_or(goal.error);
  study.tests.accuracy = goal.error;
  if (goal.error < accuracy_of_default_films) refine_films(deck, study);
  try {
    for (const auto& choice : choose_boxes(study, goal)) {
      if (choice.reaches_goal()) continue;
      study.provenance.warnings[choice.stage].push_back(
          fmt::format("accuracy {}: {}", percent(goal.error), words_on_miss(choice)));
    }
  } catch (const NumericalError& error) {
    deck.report("stages", fmt::format("no box can be chosen: {}", error.what()));
  } catch (const InputError& error) {
    deck.report("stages", fmt::format("no box can be chosen: {}", error.what()));
  }
}

std::string chosen_boxes(const Section& deck, const Study& study, std::size_t stages) {
  std::string text;
  const auto sections = deck.sections("stages");
  for (std::size_t number = 0; number < std::min(sections.size(), stages); ++number) {
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
