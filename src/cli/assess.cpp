#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/deck_assessment.hpp"
#include "breccia/error.hpp"
#include "breccia/results/stored_responder.hpp"

#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"
#include "cli/assessment_page.hpp"
#include "cli/assessment_tables.hpp"
#include "cli/calibration_tables.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/modulus_kinds.hpp"
#include "cli/narration.hpp"
#include "cli/sweep_summary.hpp"
#include "deck/calibrated_inputs.hpp"
#include "io/display.hpp"
#include "parallel/session.hpp"
#include "results/assessment_files.hpp"
#include "results/calibration_files.hpp"
#include "results/stored_study.hpp"

namespace breccia::cli {
namespace {

struct AssessArguments {
  RunArguments run;
  AssessmentOptions options;
  std::string stage;
  std::vector<std::filesystem::path> measured;
  std::string modulus;             ///< kind of the measured moduli; empty: from the names of the columns
  std::string noise, model_error;  ///< in per cent
};

/// An observer that passes on everything of the first task of a sweep, and of the others when they begin and fail.
RunObserver of_first_task(const RunObserver& observer) {
  auto task = std::make_shared<std::size_t>(0);
  return {.progress = observer.progress, .event = [observer, task](const RunEvent& happened) {
            const auto* const begun = std::get_if<TaskBegun>(&happened);
            if (begun != nullptr) *task = begun->task;
            if (*task == 0 || begun != nullptr || std::holds_alternative<TaskFailed>(happened)) observer.tell(happened);
          }};
}

/// Solves the studies of an assessment that are not complete yet.
void solve_studies(const Sweep& sweep, const AssessArguments& arguments, ProgressLine& progress) {
  const auto directory = arguments.run.results();
  auto options = arguments.run.options();
  options.resume = !options.overwrite;
  const auto observer = narrate(progress, Detail::brief);
  if (!sweep.keys.empty()) {
    refuse_failures(sweep, run_sweep(sweep, directory, options, of_first_task(observer)));
    return;
  }
  ResultTransaction results(sweep.tasks.front().study, directory, options);
  if (options.resume) {
    const auto [seconds, note] = results.take_over();
    if (!note.empty()) observer.tell(Note{note});
    if (seconds) return;
  }
  SharedStages nothing;
  static_cast<void>(run_study(results, observer, nothing));
}

std::vector<SampledCurve> curves_of(const DeckAssessment& deck, const AssessArguments& arguments) {
  const auto& tasks = deck.sweep().tasks;
  const auto directory = arguments.run.results();
  std::vector<Responder> solved;
  solved.reserve(tasks.size());
  for (const auto& task : tasks) solved.push_back(read_responder(task.directory_in(directory)));
  const auto reference = read_stored_study(tasks.front().directory_in(directory)).stages;
  return deck.curves(solved, reference, arguments.stage, arguments.run.threads);
}

/// The samples in words, from which the same ones can be told from others.
std::string source_of(const AssessArguments& arguments, std::size_t samples) {
  return fmt::format("{}, {} samples, seed {}{}", arguments.run.deck.deck.filename().string(), samples,
                     arguments.options.seed, arguments.stage.empty() ? "" : ", stage " + arguments.stage);
}

std::vector<std::string> hashes_of(const Sweep& sweep) {
  std::vector<std::string> hashes;
  for (const auto& task : sweep.tasks) hashes.push_back(task.study.provenance.hash);
  return hashes;
}

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
                                 .source = source_of(arguments_, assessment.samples),
                                 .abscissa = abscissa,
                                 .change_the_box = deck_.design().change_the_box,
                                 .measured = measured.observations,
                                 .calibration = calibration};
    const auto directory = arguments_.run.results() / "assess";
    const auto files = write_assessment({.directory = directory,
                                         .source = page.source,
                                         .studies = hashes_of(deck_.sweep()),
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
    const auto directory = arguments_.run.results() / "assess" / "measured";
    const auto stage = deck_.stage_named(arguments_.stage);
    const auto source =
        fmt::format("{}, with {}", source_of(arguments_, deck_.design().box_of.size()), fmt::join(texts, ", "));
    const auto files = write_calibration({.directory = directory,
                                          .source = source,
                                          .inputs = arguments_.measured,
                                          .studies = hashes_of(deck_.sweep()),
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
  const auto& run = arguments.run;
  watch_for_interruption();
  const DeckAssessment deck(run.deck.deck, run.deck.overrides, arguments.options);
  static_cast<void>(deck.stage_named(arguments.stage));  // refused before anything is solved
  const auto measured = measured_by(deck, arguments);
  ProgressLine progress(run.quiet || !parallel::is_first());
  progress.print(fmt::format("{}, {}:\n{}", deck.sweep().tasks.front().study.title,
                             display_count(deck.inputs().size(), "uncertain input"),
                             table_of_inputs(deck.inputs(), deck.design().change_the_box)));
  solve_studies(deck.sweep(), arguments, progress);
  if (!parallel::is_first()) return;
  progress.update("assessment", 0.0, fmt::format("{} samples", deck.design().box_of.size()));
  const auto curves = curves_of(deck, arguments);
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
  auto& run = arguments->run;
  command->add_option("DECK", run.deck.deck, "the study, a TOML file with distributions")->required()->type_name("");
  command
      ->add_option(
          "--set", run.deck.overrides,
          "replace a value of the deck, as in 'materials.hmx.shear={ value = \"5.8 GPa\", sd = \"0.6 GPa\" }'; "
          "may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
  command->add_option("--samples", arguments->options.samples, "number of samples of all inputs (default: 1000)")
      ->check(CLI::Range(100, 100'000).description(""))
      ->type_name("N");
  command
      ->add_option("--boxes", arguments->options.boxes,
                   "number of boxes, where inputs change the box (default: twice the number of polynomials of degree 2 "
                   "in these inputs, 10 at least)")
      ->check(CLI::Range(2, 10'000).description(""))
      ->type_name("N");
  command->add_option("--seed", arguments->options.seed, "seed of the boxes and of the samples (default: 1)")
      ->check(CLI::Range(0, 1 << 30).description(""))
      ->type_name("N");
  command->add_option("--stage", arguments->stage, "the stage that is assessed (default: the last one)")
      ->type_name("NAME");
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
  command->add_option("--out", run.directory, "directory for the results (default: results/<name of the deck>)")
      ->type_name("DIR");
  command->add_option("--threads", run.threads, "number of threads (default: as many as help)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command->add_flag("--overwrite", run.overwrite,
                    "replace results of other studies in the directory when the new ones are complete");
  command->add_flag("--quiet", run.quiet, "print nothing but warnings and errors");
  command->callback([arguments] { run_assess(*arguments); });
}

}  // namespace breccia::cli
