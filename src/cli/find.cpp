#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/deck_assessment.hpp"

#include "cli/assessed_deck.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/narration.hpp"
#include "deck/sought_input.hpp"
#include "io/display.hpp"
#include "parallel/session.hpp"
#include "results/design_files.hpp"
#include "results/stored_study.hpp"

namespace breccia::cli {
namespace {

struct FindArguments {
  std::string key;
  std::string condition;
  std::string model_error;  ///< in per cent
  AssessedDeck deck;
};

/// An end of the interval of an input, or the end of the range beyond which it is.
std::string end_in_words(const std::optional<double>& end, double end_of_range, const std::string& unit) {
  return end ? number_in_words(*end, unit) : "beyond " + number_in_words(end_of_range, unit);
}

/// The value that was found, with its interval.
std::string found_in_words(const UncertainInput& input, const FoundDesign& design) {
  return fmt::format("{}  {}  (95 %: {} to {})", input.name, plain_text(design.value),
                     end_in_words(design.lower, design.points.front().input, input.unit),
                     end_in_words(design.upper, design.points.back().input, input.unit));
}

/// What a study has of the quantity of a condition, beside what was wanted.
std::string reached_in_words(const Condition& condition, double reached) {
  const double ratio = reached / as_written(condition, condition.wanted.value);
  constexpr double least = 5e-4;
  const auto more =
      std::abs(ratio - 1.0) < least
          ? "as wanted"
          : fmt::format("{:.1f} % {} than wanted", 100.0 * std::abs(ratio - 1.0), ratio > 1.0 ? "more" : "less");
  return fmt::format("{}, {}", value_in_words(condition, reached), more);
}

/// Writes what was searched.
void write(const DeckAssessment& deck, const FindArguments& arguments, const SoughtInput& sought,
           const FoundDesign& design, const std::filesystem::path& directory) {
  const auto& input = deck.inputs()[sought.index];
  const auto& condition = sought.condition;
  write_design(
      {.directory = directory,
       .source = fmt::format("{}, {} for {}", source_of(deck, arguments.deck), input.name, arguments.condition),
       .studies = hashes_of(deck)},
      {.input = input.name,
       .input_unit = input.unit,
       .quantity = condition.quantity,
       .quantity_unit = std::string(unit_of(condition)),
       .wanted = as_written(condition, condition.wanted.value),
       .points = design.points});
}

void run_find(const FindArguments& arguments) {
  watch_for_interruption();
  const auto deck = read_assessed_deck(arguments.deck);
  const auto sought =
      read_sought_input(deck, arguments.key, arguments.condition, option_share("--model-error", arguments.model_error));
  ProgressLine progress(arguments.deck.run.quiet || !parallel::is_first());
  solve_studies(deck, arguments.deck, progress);
  const auto design = find_input(deck, curves_of(deck, arguments.deck, progress), sought);
  const auto& input = deck.inputs()[sought.index];
  for (const auto& warning : design.warnings) progress.warn(warning);
  progress.print(fmt::format("\n{}:\n  {}\n", arguments.condition, found_in_words(input, design)));

  // The study with this value shows how near a composite comes to what was wanted.
  const auto directory = arguments.deck.run.results() / "find";
  if (parallel::is_first()) write(deck, arguments, sought, design, directory);
  const auto study = deck.study_with(sought.index, design.value);
  auto options = arguments.deck.run.options();
  options.resume = true;
  options.overwrite = true;
  solve_unless_complete(study, directory / "study", options, progress);
  const double reached = value_of_study(read_stored_study(directory / "study").stages,
                                        deck.stage_named(arguments.deck.stage), sought.condition);
  progress.print(fmt::format("The study with {} has {}: {}", plain_text(design.value), sought.condition.quantity,
                             reached_in_words(sought.condition, reached)));
  progress.print(
      fmt::format("Results are in {}: find.csv, find.svg, and those of the study in study", directory.string()));
}

}  // namespace

void add_find(CLI::App& application) {
  auto* command = application.add_subcommand(
      "find", "find the value of an input by which a composite has what is wanted, such as a fraction");
  auto arguments = std::make_shared<FindArguments>();
  command
      ->add_option("KEY", arguments->key,
                   "the input: the path of a value of the deck, or its last steps, whose range the deck has "
                   "({ from = 0.4, to = 0.6 })")
      ->required()
      ->type_name("");
  add_assessed_deck(*command, arguments->deck);
  command
      ->add_option("--so-that", arguments->condition,
                   "what the composite is to have, as in \"G(1 ms) = 3 GPa\" or \"tan_delta(10 Hz) = 0.3\"")
      ->required()
      ->type_name("CONDITION");
  command
      ->add_option("--model-error", arguments->model_error,
                   "error of the moduli of the study, as in \"5 %\" (default: the one that it states)")
      ->type_name("PERCENT");
  command->callback([arguments] { run_find(*arguments); });
}

}  // namespace breccia::cli
