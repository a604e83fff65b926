#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/deck_assessment.hpp"

#include "cli/assessed_deck.hpp"
#include "cli/assessment_page.hpp"
#include "cli/assessment_tables.hpp"
#include "cli/calibration_tables.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/modulus_kinds.hpp"
#include "cli/narration.hpp"
#include "deck/calibrated_inputs.hpp"
#include "parallel/session.hpp"
#include "results/assessment_files.hpp"
#include "results/calibration_files.hpp"

namespace breccia::cli {
namespace {

struct AssessArguments {
  AssessedDeck deck;
  std::vector<std::filesystem::path> measured;
  std::string modulus;             ///< kind of the measured moduli; empty: from the names of the columns
  std::string noise, model_error;  ///< in per cent
};

/// The measured values that the options name; without values where they name none.
MeasuredComposite measured_by(const DeckAssessment& deck, const AssessArguments& arguments) {
  AskedObservations asked = {
      .data = {}, .modulus = ModulusKind::unspecified, .noise = option_share("--noise", arguments.noise)};
  const auto model_error = option_share("--model-error", arguments.model_error);
  for (const auto& file : arguments.measured) asked.data.push_back({0, file});
  if (!arguments.modulus.empty()) asked.modulus = modulus_kinds.at(arguments.modulus);
  return asked.data.empty() ? MeasuredComposite{} : read_measured_composite(deck, asked, model_error);
}

/// Writes and prints what was made of the uncertain inputs.
class Findings {
 public:
  Findings(const DeckAssessment& deck, const AssessArguments& arguments, ProgressLine& progress)
      : deck_(deck), arguments_(arguments), progress_(progress) {}

  void report(const Assessment& assessment, const MeasuredComposite& measured,
              const std::optional<Calibration>& calibration) {
    const auto& study = deck_.sweep().tasks.front().study;
    const auto abscissa = study.tests.abscissa();
    const AssessmentPage page = {.title = study.title,
                                 .source = source_of(deck_, arguments_.deck),
                                 .abscissa = abscissa,
                                 .change_the_box = deck_.design().change_the_box,
                                 .measured = measured.observations,
                                 .calibration = calibration};
    const auto directory = arguments_.deck.run.results() / "assess";
    const auto files = write_assessment({.directory = directory,
                                         .source = page.source,
                                         .studies = hashes_of(deck_),
                                         .page = assessment_page(page, assessment),
                                         .overwrite = true},
                                        assessment, abscissa);
    for (const auto& warning : assessment.warnings) progress_.warn(warning);
    progress_.print(fmt::format("\n{} samples{}", assessment.samples,
                                assessment.boxes > 1 ? fmt::format(" in {} boxes", assessment.boxes) : ""));
    for (const auto& curve : assessment.curves) progress_.print("\n" + table_of_curve(curve, deck_.inputs(), abscissa));
    progress_.print(fmt::format("Results are in {}: {}", directory.string(), fmt::join(files, ", ")));
  }

  void report(const MeasuredComposite& measured, const Calibration& found) {
    std::vector<std::string> texts;
    for (const auto& file : arguments_.measured) texts.push_back(file.string());
    const auto directory = arguments_.deck.run.results() / "assess" / "measured";
    const auto stage = deck_.stage_named(arguments_.deck.stage);
    const auto source = fmt::format("{}, with {}", source_of(deck_, arguments_.deck), fmt::join(texts, ", "));
    const auto files = write_calibration({.directory = directory,
                                          .source = source,
                                          .inputs = arguments_.measured,
                                          .studies = hashes_of(deck_),
                                          .overwrite = true},
                                         {measured.observations, {stage}}, found);
    for (const auto& note : measured.notes) progress_.print("note: " + note);
    for (const auto& warning : found.warnings) progress_.warn(warning);
    progress_.print(fmt::format("\n{} measured values of {}\n\n{}", measured.observations.size(), stage,
                                table_of_estimates(found.estimates)));
    for (const auto& remark : found.remarks) progress_.print(remark);
    progress_.print(fmt::format("Results are in {}: {}", directory.string(), fmt::join(files, ", ")));
  }

 private:
  const DeckAssessment& deck_;
  const AssessArguments& arguments_;
  ProgressLine& progress_;
};

void run_assess(const AssessArguments& arguments) {
  watch_for_interruption();
  const auto deck = read_assessed_deck(arguments.deck);
  static_cast<void>(deck.stage_named(arguments.deck.stage));  // refused before anything is solved
  const auto measured = measured_by(deck, arguments);
  ProgressLine progress(arguments.deck.run.quiet || !parallel::is_first());
  solve_studies(deck, arguments.deck, progress);
  if (!parallel::is_first()) return;
  const auto curves = curves_of(deck, arguments.deck, progress);
  std::optional<Calibration> calibration;
  if (!measured.observations.empty()) calibration = calibrate_inputs(deck, curves, measured);
  Findings findings(deck, arguments, progress);
  findings.report(assess(deck.inputs(), deck.design(), curves), measured, calibration);
  if (calibration) findings.report(measured, *calibration);
}

}  // namespace

void add_assess(CLI::App& application) {
  auto* command = application.add_subcommand(
      "assess", "propagate the uncertain inputs of a deck: bands of its curves, and which input matters when");
  auto arguments = std::make_shared<AssessArguments>();
  add_assessed_deck(*command, arguments->deck);
  auto* measured = command->add_option(
      "--measured", arguments->measured,
      "measured values of the composite, from which the inputs are found (docs/uncertainty.md); may be "
      "repeated");
  measured->expected(1)->take_all()->type_name("FILE");
  command
      ->add_option("--noise", arguments->noise,
                   "standard deviation of the measured values, as in \"2 %\" (default: as their deviations show)")
      ->type_name("PERCENT")
      ->needs(measured);
  command
      ->add_option("--model-error", arguments->model_error,
                   "error of the moduli of the study, as in \"5 %\" (default: the largest that it states)")
      ->type_name("PERCENT")
      ->needs(measured);
  command
      ->add_option("--modulus", arguments->modulus,
                   "kind of modulus that was measured, if the names of the columns do not say it")
      ->check(CLI::IsMember(modulus_kinds).description(""))
      ->type_name("shear|young|bulk")
      ->needs(measured);
  command->callback([arguments] { run_assess(*arguments); });
}

}  // namespace breccia::cli
