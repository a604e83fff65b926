#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/deck_assessment.hpp"

#include "cli/assessed_deck.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/narration.hpp"
#include "deck/sought_input.hpp"
#include "io/collected_mistakes.hpp"
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
std::string end_in_words(double end, const FoundDesign& design, const std::string& unit) {
  constexpr int digits = 4;
  if (std::isfinite(end)) return number_in_words(end, unit, digits);
  if (end > 0.0) return "above " + number_in_words(design.points.back().input, unit);
  return "below " + number_in_words(design.points.front().input, unit);
}

/// The value that was found, with its interval.
std::string found_in_words(const UncertainInput& input, const FoundDesign& design) {
  auto text =
      fmt::format("{}  {}  (95 %{}: {} to {})", input.name, plain_text(rounded_value(input, design.value)),
                  design.has_model_error ? "" : " without the error of the model",
                  end_in_words(design.lower, design, input.unit), end_in_words(design.upper, design, input.unit));
  if (design.without > 0.0) {
    text += fmt::format("\n  in {:.2g} % of the cases no value of the range serves", 100.0 * design.without);
  }
  return text;
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

/// Writes what was searched. Returns the names of the files.
std::vector<std::string> write(const DeckAssessment& deck, const FindArguments& arguments, const SoughtInput& sought,
                               const FoundDesign& design, double reached) {
  const auto& input = deck.inputs()[sought.index];
  const auto& condition = sought.condition;
  const auto error = arguments.model_error.empty() ? "" : ", error of the model " + arguments.model_error;
  return write_design(
      {.directory = arguments.deck.run.results() / "find",
       .source = fmt::format("{}, {} for {}{}: {}", source_of(deck, arguments.deck), input.name, arguments.condition,
                             error, plain_text(rounded_value(input, design.value))),
       .studies = hashes_of(deck)},
      {.input = input,
       .quantity = condition.quantity,
       .quantity_unit = std::string(unit_of(condition)),
       .wanted = as_written(condition, condition.wanted.value),
       .value = design.value,
       .interval = {design.lower, design.upper},
       .reached = reached,
       .points = design.points});
}

/// What is sought. Throws InputError for all mistakes in the options at once.
SoughtInput read_sought(const DeckAssessment& deck, const FindArguments& arguments) {
  SoughtInput sought;
  CollectedMistakes mistakes;
  mistakes.collect([&] { static_cast<void>(deck.stage_named(arguments.deck.stage)); });
  std::optional<double> model_error;
  mistakes.collect([&] { model_error = option_share("--model-error", arguments.model_error); });
  mistakes.collect([&] { sought = read_sought_input(deck, arguments.key, arguments.condition, model_error); });
  mistakes.refuse();
  return sought;
}

/// The value that the first process has found, on all of them.
double found_value(const FoundDesign& design) {
  return std::stod(parallel::text_of_first(fmt::format("{:.17g}", design.value)));
}

void run_find(const FindArguments& arguments) {
  watch_for_interruption();
  const auto deck = read_assessed_deck(arguments.deck);
  const auto sought = read_sought(deck, arguments);
  const auto& input = deck.inputs()[sought.index];
  const bool is_first = parallel::is_first();
  ProgressLine progress(arguments.deck.run.quiet || !is_first);
  solve_studies(deck, arguments.deck, progress);
  FoundDesign design;
  if (is_first) {
    design = find_input(deck, curves_of(deck, arguments.deck, progress), sought);
    for (const auto& warning : design.warnings) progress.warn(warning);
    progress.print(fmt::format("\n{}:\n  {}\n", arguments.condition, found_in_words(input, design)));
  }

  // The study with this value shows how near a composite comes to what was wanted.
  const auto value = rounded_value(input, found_value(design));
  const auto directory = arguments.deck.run.results() / "find" / "study";
  auto options = arguments.deck.run.options();
  options.resume = true;
  options.overwrite = true;
  solve_unless_complete(deck.study_with(sought.index, value), directory, options, progress);
  if (!is_first) return;
  const double reached =
      value_of_study(read_stored_study(directory).stages, deck.stage_named(arguments.deck.stage), sought.condition);
  const auto files = write(deck, arguments, sought, design, reached);
  const auto doubt = doubt_on(design, sought.condition, reached);
  if (!doubt.empty()) progress.warn(doubt);
  progress.print(fmt::format("The study with {} has {}: {}", plain_text(value), sought.condition.quantity,
                             reached_in_words(sought.condition, reached)));
  progress.print(fmt::format("Results are in {}: {}, and those of the study in study", directory.parent_path().string(),
                             fmt::join(files, ", ")));
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
                   R"(what the composite is to have, as in "G(1 ms) = 3 GPa" or "tan_delta(10 Hz) = 0.3")")
      ->required()
      ->type_name("CONDITION");
  command
      ->add_option("--model-error", arguments->model_error,
                   R"(error of the moduli of the study, as in "5 %" (default: the one that it states))")
      ->type_name("PERCENT");
  command->callback([arguments] { run_find(*arguments); });
}

}  // namespace breccia::cli
