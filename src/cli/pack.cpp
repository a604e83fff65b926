#include "breccia/campaign/pack.hpp"

#include <memory>

#include <fmt/format.h>

#include "breccia/campaign/resume.hpp"
#include "breccia/campaign/sweep_directory.hpp"
#include "breccia/parallel/session.hpp"

#include "command.hpp"
#include "interruption.hpp"
#include "narration.hpp"
#include "sweep_summary.hpp"

namespace breccia::cli {

void add_pack(CLI::App& application) {
  auto* command =
      application.add_subcommand("pack", "pack the particles of a study and write the microstructures alone");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto options = arguments->options();
    const auto sweep = arguments->deck.read();
    watch_for_interruption();
    Progress progress(arguments->quiet || !parallel::is_first());
    const auto lock = hold_sweep_directory(sweep, arguments->results());
    if (lock) refuse_objections(sweep, arguments->results(), options);
    for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
      const auto& task = sweep.tasks[i];
      if (!task.name.empty()) progress.print(heading_of(sweep, i));
      const auto directory = task.directory_in(arguments->results());
      if (take_over_complete_run(task.study, directory)) {
        progress.print(fmt::format("The results in {} are complete", directory.string()));
        continue;
      }
      const auto result = pack_study(task.study, directory, options, narrate(progress));
      for (const auto& stage : result.stages) {
        progress.print(fmt::format("  {}", (directory / stage.name / "microstructure.svg").string()));
      }
    }
  });
}

}  // namespace breccia::cli
