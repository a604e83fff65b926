#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/plan.hpp"

#include "cli/command.hpp"
#include "cli/filler_summary.hpp"
#include "cli/progress_line.hpp"
#include "cli/summary.hpp"
#include "cli/sweep_summary.hpp"
#include "homogenisation/quality.hpp"
#include "io/display.hpp"
#include "io/percentage.hpp"
#include "parallel/available_memory.hpp"

namespace breccia::cli {
namespace {

std::string memory(double bytes) {
  return display(bytes, "B");
}

std::string lines_of_dynamic_test(const std::string& stage, const TestPlan& test) {
  auto text = fmt::format("  {} {}, {}, dynamic: {:.0f} points, about {}\n", stage, name_of(*test.load),
                          name_of(test.boundary), test.unknowns, memory(test.bytes));
  std::int64_t steps = 0;
  for (const auto& domain : test.domains) {
    steps += domain.steps;
    text += fmt::format("    density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps of {:.3g} s, {}\n",
                        domain.mass_scaling, domain.window.begin, domain.window.end, domain.steps, domain.time_step,
                        display_count(domain.terms, "term"));
  }
  return text + fmt::format("    together {} steps, about {} at {:.0f} million points x steps/s here\n", steps,
                            display_duration(test.seconds), test.speed / 1e6);
}

std::string lines_of_test(const std::string& stage, const TestPlan& test) {
  if (test.method == Method::dynamic) return lines_of_dynamic_test(stage, test);
  return fmt::format("  {} {}, quasi-static: {}, {:.0f} unknowns, about {}, some {}\n", stage, name_of(test.boundary),
                     test.size, test.unknowns, memory(test.bytes), display_duration(test.seconds, 1));
}

/// The error of the finest grid of a stage, by its name, and the cells per side for errors of these sizes [-].
std::string line_of_grid(const std::string& stage, const GridPlan& grid, const std::vector<double>& errors) {
  const auto shown = fmt::format("{:.2g}", grid.cells());
  const auto width = fmt::format("{} {} {}", shown, shown == "1" ? "cell" : "cells", grid.place);
  if (!grid.rule) {
    return fmt::format("  {}: {}; no rule gives the error of the grid, nor cells for an error: {}\n", stage, width,
                       grid.without_rule);
  }
  std::vector<std::string> advice;
  advice.reserve(errors.size());
  for (const double error : errors) {
    const auto cells = grid.cells_for(error);
    if (cells) advice.push_back(fmt::format("{:.0f} for {:.2g} %", *cells, 100.0 * error));
  }
  const auto expected = grid.error();
  const auto error = expected ? fmt::format("is up to about {:.2g} % {}", 100.0 * *expected, words_on_rule(grid))
                              : "may be of any size";
  const auto cells = advice.empty()
                         ? fmt::format("no number of cells is known for {:.2g} %", 100.0 * std::ranges::max(errors))
                         : fmt::format("cells = {}", fmt::join(advice, ", "));
  return fmt::format("  {}: {}, the error of the grid {}; {}\n", stage, width, error, cells);
}

/// The error of the packed box of a stage in place of all such boxes, and the numbers of particles for errors of these
/// sizes [-]. The error falls with the root of their number.
std::string line_of_sample(const StagePlan& stage, const std::vector<double>& errors) {
  std::size_t particles = 0;
  for (const auto& filler : stage.fillers) particles += filler.particles;
  if (!stage.sample_error || particles == 0 || *stage.sample_error == 0.0) return {};
  std::vector<std::string> advice;
  for (const double error : errors) {
    const double ratio = *stage.sample_error / error;
    advice.push_back(fmt::format("{:.0f} would have {:.2g} %",
                                 std::max(1.0, std::ceil(ratio * ratio * static_cast<double>(particles))),
                                 100.0 * error));
  }
  return fmt::format("  {}: {} particles, the error of the packing is up to about {:.2g} % by a rule; {}\n",
                     stage.stage, particles, 100.0 * *stage.sample_error, fmt::join(advice, ", "));
}

/// Time and memory of all tests of a study, whose dynamic tests take several cores.
std::string costs_of(const Study& study, double seconds, double bytes) {
  const bool is_quasistatic = std::ranges::count(study.tests.methods, Method::dynamic) == 0;
  return fmt::format("about {}{}, at most {} of memory", display_duration(seconds),
                     is_quasistatic ? " on one core" : "", memory(bytes));
}

/// A line about the least time and memory of each of several processes.
std::string line_of_processes(int processes, const Study& study, const StudyPlan& plan, double seconds) {
  if (processes == 1) return {};
  const double bytes = plan.bytes();
  if (const auto factors = memory_of_factors(study, plan)) {
    return fmt::format(
        "on {} processes: spheres with flow through gaps take sparse factors there, about {} of memory together, and "
        "more time than on one process\n",
        processes, memory(*factors));
  }
  return fmt::format("on {0} processes with a core each at best 1/{0} of the time, {1}, and {2} of memory a process\n",
                     processes, display_duration(seconds / processes), memory(memory_of_process(bytes, processes)));
}

struct Arguments {
  DeckArguments deck;
  std::vector<std::string> errors;
  int processes = 1;
};

constexpr auto heading = "\nplan, with an estimate of the composite's modulus (a run computes it and may need less)\n";

void print(const Study& study, const StudyPlan& plan, const std::vector<double>& errors, int processes) {
  std::vector<std::vector<FillerStatistics>> fillers;
  for (const auto& stage : plan.stages) {
    for (const auto& test : stage.tests) fmt::print("{}", lines_of_test(stage.stage, test));
    if (stage.grid) fmt::print("{}", line_of_grid(stage.stage, *stage.grid, errors));
    fmt::print("{}", line_of_sample(stage, errors));
    for (const auto& remark : stage.remarks) fmt::print("  {}: {}\n", stage.stage, remark);
    for (const auto& warning : stage.warnings) fmt::print("warning: {}\n", warning);
    fillers.push_back(stage.fillers);
  }
  fmt::print("{}together {}\n{}", filler_summary(study, fillers), costs_of(study, plan.seconds(), plan.bytes()),
             line_of_processes(processes, study, plan, plan.seconds()));
}

/// Makes a plan whose packings, which may take long, are followed by a line.
template <class Task>
auto followed_plan_of(const Task& task) {
  std::fflush(stdout);
  ProgressLine progress(false);
  return plan_of(task, [&](const Progress& now) { progress.update(now.what, now.share, now.details); });
}

void check_study(const Study& study, const std::vector<double>& errors, int processes) {
  fmt::print("{}{}", summary(study), heading);
  print(study, followed_plan_of(study), errors, processes);
  // Several processes may use the memory of several machines.
  if (processes == 1) require_memory(study, parallel::available_memory());
}

/// "seed-1", or "seed-1 and 2 more".
std::string name_of(const Sweep& sweep, const SweepPlan::Part& part) {
  const auto& first = sweep.tasks[part.tasks.front()].name;
  return part.tasks.size() == 1 ? first : fmt::format("{} and {} more", first, part.tasks.size() - 1);
}

/// Prints the warnings about a part that were not printed for the first part.
void print_new_warnings(const Sweep& sweep, const SweepPlan& plan, const SweepPlan::Part& part) {
  const auto& first = plan.parts.front().plan.stages;
  for (std::size_t i = 0; i < part.plan.stages.size(); ++i) {
    for (const auto& warning : part.plan.stages[i].warnings) {
      if (i < first.size() && std::ranges::count(first[i].warnings, warning) > 0) continue;
      fmt::print("warning: {}: {}\n", name_of(sweep, part), warning);
    }
  }
}

void check_sweep(const Sweep& sweep, const std::vector<double>& errors, int processes) {
  fmt::print("a sweep of {} tasks\n\n{}\nthe first one:\n\n", sweep.tasks.size(), table_of_tasks(sweep));
  const auto& study = sweep.tasks.front().study;
  fmt::print("{}", summary(study));
  const auto plan = followed_plan_of(sweep);
  std::vector<std::string> failures;
  for (const auto& part : plan.parts) {
    if (!part.failure.empty()) {
      failures.push_back(fmt::format("{}: {}", name_of(sweep, part), part.failure));
    } else if (&part == &plan.parts.front()) {
      fmt::print("{}", heading);
      print(study, part.plan, errors, 1);
      if (plan.parts.size() > 1) fmt::print("\nthe others, each:\n");
    } else {
      const auto& of_part = sweep.tasks[part.tasks.front()].study;
      fmt::print("  {}: {}\n", name_of(sweep, part), costs_of(of_part, part.plan.seconds(), part.plan.bytes()));
      print_new_warnings(sweep, plan, part);
    }
  }
  const auto& largest = plan.largest();
  fmt::print("\nall {} tasks {}, in {}\n{}", sweep.tasks.size(), costs_of(study, plan.seconds(), largest.plan.bytes()),
             name_of(sweep, largest),
             line_of_processes(processes, sweep.tasks[largest.tasks.front()].study, largest.plan, plan.seconds()));
  if (!failures.empty()) throw NumericalError(fmt::format("{}", fmt::join(failures, "\n")));
  if (processes == 1) require_memory(sweep, parallel::available_memory());
}

/// The errors given by the option --error [-]. Throws InputError for one that is not a percentage below 100 %.
std::vector<double> errors_of(const std::vector<std::string>& texts) {
  if (texts.empty()) return {0.05, 0.02, 0.01};
  std::vector<double> errors;
  for (const auto& text : texts) {
    const auto error = parse_percentage(text);
    if (!error || !(*error > 0.0 && *error < 1.0)) {
      throw InputError(
          fmt::format(R"(--error: expected a percentage between 0 and 100 %, such as "2 %", got "{}")", text));
    }
    errors.push_back(*error);
  }
  return errors;
}

}  // namespace

void add_check(CLI::App& application) {
  auto* command =
      application.add_subcommand("check", "check a deck: report every mistake in it, estimate time and memory");
  auto arguments = std::make_shared<Arguments>();
  add_deck_arguments(*command, arguments->deck);
  command
      ->add_option("--error", arguments->errors,
                   R"(tell the cells for these errors of the modulus (default: "5 %" "2 %" "1 %"))")
      ->type_name("SHARE ...");
  command
      ->add_option("--processes", arguments->processes,
                   "tell the memory and the time of each of N processes under mpirun at best, too")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20).description(""));
  command->callback([arguments] {
    const auto errors = errors_of(arguments->errors);
    const auto sweep = arguments->deck.read();
    if (sweep.keys.empty()) {
      check_study(sweep.tasks.front().study, errors, arguments->processes);
    } else {
      check_sweep(sweep, errors, arguments->processes);
    }
  });
}

}  // namespace breccia::cli
