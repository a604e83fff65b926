#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "breccia/report/display.hpp"
#include "breccia/study/memory.hpp"
#include "breccia/study/run.hpp"
#include "breccia/study/stage_warnings.hpp"

#include "command.hpp"
#include "summary.hpp"
#include "sweep_summary.hpp"

namespace breccia::cli {
namespace {

std::string dynamic_plan(const Study& study, const Stage& stage, const Discretisation& discretisation,
                         Boundary boundary, Load load) {
  const auto test = make_dynamic_test(study, stage, expected_matrix(study, stage), discretisation, boundary, load, 0);
  const auto plan = plan_dynamic_test(test);
  const double speed = trial_speed(test);
  const auto points = test.discretisation.points();
  std::int64_t steps = 0;
  auto text = fmt::format("  {} {}, {}, dynamic: {} points, about {:.0f} MB\n", stage.name, name_of(load),
                          bound_of(boundary), points, static_cast<double>(plan.bytes) / 1e6);
  for (const auto& domain : plan.domains) {
    steps += domain.steps;
    text += fmt::format("    density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps of {:.3g} s, {} terms\n",
                        domain.density_factor, domain.window.begin, domain.window.end, domain.steps, domain.time_step,
                        domain.terms);
  }
  return text + fmt::format("    together {} steps, about {:.2g} s at {:.0f} million points x steps/s here\n", steps,
                            static_cast<double>(points) * static_cast<double>(steps) / speed, speed / 1e6);
}

bool is_direct(const Study& study, double unknowns) {
  return study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), 1);
}

/// Wall time [s] on a core of the year 2020, from experience.
double quasistatic_time(const Study& study, const Stage& stage, double unknowns) {
  const auto loads = static_cast<double>(loads_of(study, stage).size());
  constexpr double warm_up_decades = 3.0;
  const double snapshots = study.tests.quasistatic.range == SampledRange::matrix ? 11.0 : 9.0;
  const bool direct = is_direct(study, unknowns);
  const double factorisation = direct ? 2.2e-6 : 1.2e-6, solve = direct ? 0.8e-6 : 1.5e-6;
  if (study.tests.quasistatic.solver == Solver::reduced) return snapshots * unknowns * (factorisation + solve * loads);
  const double decades = warm_up_decades + std::log10(study.tests.last_time / study.tests.first_time);
  const double solves = 1.5 * decades * study.tests.quasistatic.steps_per_decade;
  return solves * unknowns * (factorisation + solve) * loads;
}

std::string quasistatic_plan(const Study& study, const Stage& stage, Boundary boundary, int cells) {
  const double unknowns = 2.0 * cells * cells;
  return fmt::format("  {} {}, quasi-static: {} x {} cells, {:.0f} unknowns, about {:.0f} MB, some {}\n", stage.name,
                     bound_of(boundary), cells, cells, unknowns, quasistatic_memory(study, stage, cells) / 1e6,
                     display(quasistatic_time(study, stage, unknowns), "s", 1));
}

std::string plan_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  std::string text;
  for (const int cells : grids_of(stage)) {
    const auto discretisation = discretise(packed.microstructure, cells);
    for (const auto bound : study.tests.bounds) {
      for (const auto method : study.tests.methods) {
        const auto boundary = boundary_of(bound);
        if (method == Method::quasistatic) text += quasistatic_plan(study, stage, boundary, cells);
        if (method == Method::quasistatic) continue;
        for (const auto load : loads_of(study, stage))
          text += dynamic_plan(study, stage, discretisation, boundary, load);
      }
    }
  }
  return text;
}

void print_plan(const Study& study) {
  fmt::print("{}\nplan, with the composite's modulus by estimate (a run finds out and may need less)\n",
             summary(study));
  for (const auto& stage : study.stages) {
    const auto packed = make_microstructure(stage);
    fmt::print("{}", plan_of(study, stage, packed));
    for (const auto& warning : warnings_on(study, stage, packed)) fmt::print("warning: {}\n", warning);
  }
  require_memory(study, available_memory());
}

}  // namespace

void add_check(CLI::App& application) {
  auto* command =
      application.add_subcommand("check", "read a deck, report every mistake in it, show what it will take");
  auto arguments = std::make_shared<DeckArguments>();
  add_deck_arguments(*command, *arguments);
  command->callback([arguments] {
    const auto sweep = arguments->read();
    if (!sweep.keys.empty()) {
      fmt::print("a sweep of {} tasks\n\n{}\nthe first one:\n\n", sweep.tasks.size(), table_of_tasks(sweep));
    }
    print_plan(sweep.tasks.front().study);
  });
}

}  // namespace breccia::cli
