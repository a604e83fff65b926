#include "campaign/pack.hpp"

#include <memory>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "campaign/result_transaction.hpp"
#include "campaign/sweep_directory.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/narration.hpp"
#include "cli/sweep_summary.hpp"
#include "parallel/session.hpp"

namespace breccia::cli {
namespace {

void pack(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
          ProgressLine& progress) {
  const auto observer = narrate(progress, Detail::brief);
  ResultTransaction results(study, directory, options);
  if (const auto [seconds, note] = results.take_over(); seconds) {
    if (!note.empty()) observer.tell(Note{note});
    return progress.print(fmt::format("The results in {} are complete", directory.string()));
  }
  const auto result = pack_study(results, observer);
  for (const auto& stage : result.stages) {
    progress.print(fmt::format("  {}", (directory / stage.name / "microstructure.svg").string()));
  }
}

/// Packs all tasks of a sweep. If some tasks cannot be packed, the other tasks still are.
void pack_all(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
              ProgressLine& progress) {
  SweepResult result(sweep.tasks.size());
  const auto fail = [&](std::size_t task, const Error& error) {
    result[task] = {.state = TaskState::failed, .error = error.what()};
    progress.print(fmt::format("{} has failed: {}", heading_of(sweep, task), error.what()));
  };
  for (std::size_t task = 0; task < sweep.tasks.size(); ++task) {
    stop_if_interrupted();
    progress.print(heading_of(sweep, task));
    try {
      pack(sweep.tasks[task].study, sweep.tasks[task].directory_in(directory), options, progress);
    } catch (const NumericalError& error) {
      fail(task, error);
    } catch (const DirectoryInUse&) {
      throw;  // another process is writing there: the task has not failed
    } catch (const InputError& error) {
      fail(task, error);
    }
  }
  refuse_failures(sweep, result);
}

}  // namespace

void add_pack(CLI::App& application) {
  auto* command =
      application.add_subcommand("pack", "pack the particles of a study and write the microstructures alone");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto options = arguments->options();
    watch_for_interruption();
    const auto sweep = arguments->deck.read();
    ProgressLine progress(arguments->quiet || !parallel::is_first());
    if (sweep.keys.empty()) return pack(sweep.tasks.front().study, arguments->results(), options, progress);
    const SweepDirectory held(sweep, arguments->results(), options);
    pack_all(sweep, arguments->results(), options, progress);
  });
}

}  // namespace breccia::cli
