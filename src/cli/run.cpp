#include "breccia/study/run.hpp"

#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "breccia/parallel/session.hpp"
#include "breccia/study/deck.hpp"

#include "command.hpp"
#include "interruption.hpp"
#include "narration.hpp"
#include "tables.hpp"

namespace breccia::cli {
namespace {

std::string_view what_is(std::string_view file) {
  return file == "response.h5" ? "response" : "point fields";
}

}  // namespace

void add_run(CLI::App& application) {
  auto* command = application.add_subcommand("run", "run a study: pack, test, and write the results");
  auto arguments = std::make_shared<RunArguments>();
  add_run_arguments(*command, *arguments);
  command
      ->add_option("--petsc", arguments->petsc_options,
                   "options for PETSc, such as \"-quasistatic_ksp_monitor\" (docs/decks.md)")
      ->type_name("OPTIONS");
  command->callback([arguments] {
    const auto study = read_study(arguments->deck.deck, arguments->deck.overrides);
    watch_for_interruption();
    if (!arguments->petsc_options.empty()) parallel::set_petsc_options(arguments->petsc_options);
    Progress progress(arguments->quiet || parallel::rank() != 0);
    const auto result = run_study(study, arguments->results(), arguments->threads, narrate(progress));
    progress.print(closing_tables(study, result));
    progress.print(fmt::format("Results are in {}: curves.csv, prony.csv, study.json", arguments->results().string()));
    for (const auto& stage : result.stages) {
      const auto directory = arguments->results() / stage.name;
      progress.print(fmt::format("  microstructure  {}", (directory / "microstructure.svg").string()));
      progress.print(fmt::format("  modulus         {}", (directory / "modulus.svg").string()));
      for (const auto* file : {"fields.vtkhdf", "response.h5"}) {
        if (std::filesystem::exists(directory / file)) {
          progress.print(fmt::format("  {:<15} {}", what_is(file), (directory / file).string()));
        }
      }
    }
  });
}

}  // namespace breccia::cli
