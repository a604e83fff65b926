#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "breccia/study/deck.hpp"
#include "breccia/study/run.hpp"

#include "command.hpp"
#include "summary.hpp"

namespace breccia::cli {
namespace {

std::string plan_of(const Study& study, const Stage& stage, const StageMicrostructure& packed, Load load) {
  const auto test = make_test(study, stage, packed.microstructure, load, 0);
  const auto plan = plan_dynamic_test(test);
  const double speed = trial_speed(test);
  const auto points = test.discretisation.points();
  std::int64_t steps = 0;
  auto text = fmt::format("  {} {}: {} points, about {:.0f} MB\n", stage.name, name_of(load), points,
                          static_cast<double>(plan.bytes) / 1e6);
  for (const auto& domain : plan.domains) {
    steps += domain.steps;
    text += fmt::format("    density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps of {:.3g} s, {} terms\n",
                        domain.density_factor, domain.window.begin, domain.window.end, domain.steps, domain.time_step,
                        domain.terms);
  }
  return text + fmt::format("    together {} steps, about {:.2g} s at {:.0f} million points x steps/s here\n", steps,
                            static_cast<double>(points) * static_cast<double>(steps) / speed, speed / 1e6);
}

}  // namespace

void add_check(CLI::App& application) {
  auto* command =
      application.add_subcommand("check", "read a deck, report every mistake in it, show what it will take");
  auto arguments = std::make_shared<DeckArguments>();
  add_deck_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto study = read_study(arguments->deck, arguments->overrides);
    fmt::print("{}\nplan, with the composite's modulus by estimate (a run finds out and may need less)\n",
               summary(study));
    for (const auto& stage : study.stages) {
      const auto packed = make_microstructure(stage);
      for (const auto load : study.tests.loads) fmt::print("{}", plan_of(study, stage, packed, load));
      for (const auto& warning : packed.warnings) fmt::print("warning: {}\n", warning);
    }
  });
}

}  // namespace breccia::cli
