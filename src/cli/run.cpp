#include "breccia/study/run.hpp"

#include <memory>

#include <fmt/format.h>

#include "breccia/study/deck.hpp"

#include "command.hpp"
#include "interruption.hpp"
#include "narration.hpp"

namespace breccia::cli {

void add_run(CLI::App& application) {
  auto* command = application.add_subcommand("run", "run a study: pack, test, and write the results");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto study = read_study(arguments->deck.deck, arguments->deck.overrides);
    watch_for_interruption();
    Progress progress(arguments->quiet);
    const auto result = run_study(study, arguments->results(), arguments->threads, narrate(progress));
    progress.print(closing_table(study, result));
    progress.print(fmt::format("\nResults are in {}: curves.csv, study.json", arguments->results().string()));
    for (const auto& stage : result.stages) {
      const auto directory = arguments->results() / stage.name;
      progress.print(fmt::format("  microstructure  {}", (directory / "microstructure.svg").string()));
      progress.print(fmt::format("  modulus         {}", (directory / "modulus.svg").string()));
      progress.print(fmt::format("  point fields    {}", (directory / "fields.vtkhdf").string()));
    }
  });
}

}  // namespace breccia::cli
