#include <memory>

#include <fmt/format.h>

#include "breccia/study/deck.hpp"
#include "breccia/study/run.hpp"

#include "command.hpp"
#include "interruption.hpp"
#include "narration.hpp"

namespace breccia::cli {

void add_pack(CLI::App& application) {
  auto* command = application.add_subcommand("pack", "make the microstructures of a study alone");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto study = read_study(arguments->deck.deck, arguments->deck.overrides);
    watch_for_interruption();
    Progress progress(arguments->quiet);
    const auto result = pack_study(study, arguments->results(), narrate(progress));
    for (const auto& stage : result.stages) {
      progress.print(fmt::format("  {}", (arguments->results() / stage.name / "microstructure.svg").string()));
    }
  });
}

}  // namespace breccia::cli
