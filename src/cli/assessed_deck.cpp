#include "cli/assessed_deck.hpp"

#include <cstddef>
#include <memory>
#include <variant>

#include <fmt/format.h>

#include "breccia/results/stored_responder.hpp"

#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"
#include "cli/assessment_tables.hpp"
#include "cli/sweep_summary.hpp"
#include "io/display.hpp"
#include "parallel/session.hpp"
#include "results/stored_study.hpp"

namespace breccia::cli {
namespace {

/// An observer that passes on everything of the first task of a sweep, and of the others when they begin and fail.
RunObserver of_first_task(const RunObserver& observer) {
  auto task = std::make_shared<std::size_t>(0);
  return {.progress = observer.progress, .event = [observer, task](const RunEvent& happened) {
            const auto* const begun = std::get_if<TaskBegun>(&happened);
            if (begun != nullptr) *task = begun->task;
            if (*task == 0 || begun != nullptr || std::holds_alternative<TaskFailed>(happened)) observer.tell(happened);
          }};
}

}  // namespace

void add_assessed_deck(CLI::App& command, AssessedDeck& arguments) {
  auto& run = arguments.run;
  command.add_option("DECK", run.deck.deck, "the study, a TOML file with distributions")->required()->type_name("");
  command
      .add_option("--set", run.deck.overrides,
                  "replace a value of the deck, as in 'materials.hmx.shear={ value = \"5.8 GPa\", sd = \"0.6 GPa\" }'; "
                  "may be repeated")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false);
  command.add_option("--samples", arguments.options.samples, "number of samples of all inputs (default: 1000)")
      ->check(CLI::Range(100, 100'000).description(""))
      ->type_name("N");
  command
      .add_option("--boxes", arguments.options.boxes,
                  "number of boxes, where inputs change the box (default: twice the number of polynomials of degree 2 "
                  "in these inputs, 10 at least)")
      ->check(CLI::Range(2, 10'000).description(""))
      ->type_name("N");
  command.add_option("--seed", arguments.options.seed, "seed of the boxes and of the samples (default: 1)")
      ->check(CLI::Range(0, 1 << 30).description(""))
      ->type_name("N");
  command.add_option("--stage", arguments.stage, "the stage that is assessed (default: the last one)")
      ->type_name("NAME");
  command.add_option("--out", run.directory, "directory for the results (default: results/<name of the deck>)")
      ->type_name("DIR");
  command.add_option("--threads", run.threads, "number of threads (default: as many as help)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  command.add_flag("--overwrite", run.overwrite,
                   "replace results of other studies in the directory when the new ones are complete");
  command.add_flag("--quiet", run.quiet, "print nothing but warnings and errors");
}

DeckAssessment read_assessed_deck(const AssessedDeck& arguments) {
  return {arguments.run.deck.deck, arguments.run.deck.overrides, arguments.options};
}

void solve_unless_complete(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                           ProgressLine& progress) {
  const auto observer = narrate(progress, Detail::brief);
  ResultTransaction results(study, directory, options);
  if (options.resume) {
    const auto [seconds, note] = results.take_over();
    if (!note.empty()) observer.tell(Note{note});
    if (seconds) return;
  }
  SharedStages nothing;
  static_cast<void>(run_study(results, observer, nothing));
}

void solve_studies(const DeckAssessment& deck, const AssessedDeck& arguments, ProgressLine& progress) {
  const auto& sweep = deck.sweep();
  const auto& study = sweep.tasks.front().study;
  progress.print(fmt::format("{}, {}:\n{}", study.title, display_count(deck.inputs().size(), "uncertain input"),
                             table_of_inputs(deck.inputs(), deck.design().change_the_box)));
  const auto directory = arguments.run.results();
  auto options = arguments.run.options();
  options.resume = !options.overwrite;
  if (sweep.keys.empty()) {
    solve_unless_complete(study, directory, options, progress);
    return;
  }
  refuse_failures(sweep, run_sweep(sweep, directory, options, of_first_task(narrate(progress, Detail::brief))));
}

std::vector<SampledCurve> curves_of(const DeckAssessment& deck, const AssessedDeck& arguments, ProgressLine& progress) {
  progress.update("assessment", 0.0, fmt::format("{} samples", deck.design().box_of.size()));
  const auto& tasks = deck.sweep().tasks;
  const auto directory = arguments.run.results();
  std::vector<Responder> solved;
  solved.reserve(tasks.size());
  for (const auto& task : tasks) solved.push_back(read_responder(task.directory_in(directory)));
  const auto reference = read_stored_study(tasks.front().directory_in(directory)).stages;
  return deck.curves(solved, reference, arguments.stage, arguments.run.threads);
}

std::string source_of(const DeckAssessment& deck, const AssessedDeck& arguments) {
  return fmt::format("{}, {} samples, seed {}{}", arguments.run.deck.deck.filename().string(),
                     deck.design().box_of.size(), arguments.options.seed,
                     arguments.stage.empty() ? "" : ", stage " + arguments.stage);
}

std::vector<std::string> hashes_of(const DeckAssessment& deck) {
  std::vector<std::string> hashes;
  for (const auto& task : deck.sweep().tasks) hashes.push_back(task.study.provenance.hash);
  return hashes;
}

}  // namespace breccia::cli
