#include "breccia/campaign/run.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/narration.hpp"
#include "cli/sweep_summary.hpp"
#include "cli/tables.hpp"
#include "parallel/session.hpp"

namespace breccia::cli {
namespace {

std::string_view what_is(std::string_view file) {
  if (file == "modulus.svg") return "modulus";
  return file == "response.h5" ? "response" : "point fields";
}

/// The names of the tables that a run has written. Not every run writes dynamic.csv and the engineering moduli.
std::vector<std::string> tables_in(const std::filesystem::path& directory) {
  std::vector<std::string> tables = {"curves.csv",  "prony.csv",       "study.json",
                                     "dynamic.csv", "engineering.csv", "engineering_dynamic.csv"};
  std::erase_if(tables, [&](const std::string& table) { return !std::filesystem::exists(directory / table); });
  return tables;
}

/// Prints the names of the files of a study in full.
void print_files(const StudyResult& result, const std::filesystem::path& directory, ProgressLine& progress) {
  progress.print(fmt::format("  tables          {}", fmt::join(tables_in(directory), ", ")));
  for (const auto& stage : result.stages) {
    const auto of_stage = directory / stage.name;
    progress.print(fmt::format("  microstructure  {}", (of_stage / "microstructure.svg").string()));
    for (const auto* file : {"modulus.svg", "fields.vtkhdf", "response.h5"}) {
      if (std::filesystem::exists(of_stage / file)) {
        progress.print(fmt::format("  {:<15} {}", what_is(file), (of_stage / file).string()));
      }
    }
  }
}

void run_single(const Study& study, const RunArguments& arguments, const RunOptions& options, ProgressLine& progress) {
  const auto directory = arguments.results();
  const auto observer = narrate(progress, arguments.detail());
  ResultTransaction results(study, directory, options);
  if (arguments.resume) {
    const auto [seconds, note] = results.take_over();
    if (!note.empty()) observer.tell(Note{note});
    if (seconds) return progress.print(fmt::format("The results in {} are complete", directory.string()));
  }
  SharedStages nothing;
  const auto result = run_study(results, observer, nothing);
  progress.print(closing_tables(study, result, arguments.detail()));
  // Those of stages that an earlier run has finished.
  if (parallel::is_first()) {
    for (const auto& stage : result.stages) {
      for (const auto& warning : stage.warnings) progress.warn(warning);
    }
  }
  progress.print(fmt::format("Results are in {}: open {}", directory.string(), (directory / "report.html").string()));
  if (arguments.verbose) print_files(result, directory, progress);
}

void run_all(const Sweep& sweep, const RunArguments& arguments, const RunOptions& options, ProgressLine& progress) {
  const auto directory = arguments.results();
  const auto result = run_sweep(sweep, directory, options, narrate(progress, arguments.detail()));
  progress.print(closing_table(sweep, result));
  progress.print(fmt::format("Results are in {}", directory.string()));
  for (const auto* file : {"report.html", "sweep.csv", "sweep_dynamic.csv", "spread.csv", "spread_dynamic.csv",
                           "sweep.json", "sweep.svg"}) {
    if (std::filesystem::exists(directory / file)) progress.print(fmt::format("  {}", (directory / file).string()));
  }
  refuse_failures(sweep, result);
}

/// Names the options that PETSc has not used: those of another solver, or misspelt ones.
void note_unused_petsc_options(ProgressLine& progress) {
  const auto unused = parallel::unused_petsc_options();
  if (!unused.empty()) progress.print(fmt::format("note: PETSc has not used {}", fmt::join(unused, ", ")));
}

}  // namespace

void add_run(CLI::App& application) {
  auto* command =
      application.add_subcommand("run", "run a study: pack the particles, run the virtual tests, write the results");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace results of other studies in the directory when the new ones are complete");
  command->add_flag("--no-memory-check", arguments->ignore_memory,
                    "start even if the study may not fit into the memory");
  command->add_flag("--verbose", arguments->verbose,
                    "print the tables of all stages, the error of each calculation and the names of all files");
  command
      ->add_option("--processes-per-task", arguments->processes_per_task,
                   "for a sweep under mpirun: N processes share a task, and the tasks run side by side")
      ->check(CLI::Range(1, 1 << 20).description(""))
      ->type_name("N");
  command
      ->add_option("--petsc", arguments->petsc_options,
                   "options for PETSc, such as \"-quasistatic_ksp_monitor\" (docs/decks.md)")
      ->type_name("OPTIONS");
  command->callback([arguments] {
    const auto options = arguments->options();
    if (options.overwrite && options.resume) {
      throw InputError("--overwrite starts a new run, --resume continues the earlier one: expected only one of them");
    }
    if (arguments->quiet && arguments->verbose) {
      throw InputError("--quiet prints less, --verbose more: expected only one of them");
    }
    watch_for_interruption();
    const auto sweep = arguments->deck.read();
    if (arguments->processes_per_task > 0) {
      if (sweep.keys.empty())
        throw InputError("--processes-per-task: expected a sweep, but the deck and the options have none");
      parallel::divide(arguments->processes_per_task);
    }
    if (!arguments->petsc_options.empty()) parallel::set_petsc_options(arguments->petsc_options);
    ProgressLine progress(arguments->quiet || !parallel::is_first());
    if (sweep.keys.empty()) {
      run_single(sweep.tasks.front().study, *arguments, options, progress);
    } else {
      run_all(sweep, *arguments, options, progress);
    }
    if (!arguments->petsc_options.empty()) note_unused_petsc_options(progress);
  });
}

}  // namespace breccia::cli
