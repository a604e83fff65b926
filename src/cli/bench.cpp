#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmark/kernel_benchmark.hpp"
#include "cli/bench_results.hpp"
#include "cli/command.hpp"
#include "cli/interruption.hpp"
#include "cli/progress_line.hpp"
#include "discretisation/cell_shape.hpp"
#include "parallel/session.hpp"

namespace breccia::cli {
namespace {

std::vector<std::string> known_formulations() {
  return {std::string(name_of(Formulation::total_lagrangian)), std::string(name_of(Formulation::classical))};
}

struct BenchArguments {
  std::vector<double> points;  ///< empty: a small and a large number
  std::vector<int> terms = {0, 1, 5, 10};
  std::vector<int> threads;               ///< empty: 1 and all cores; with several processes 1
  std::vector<std::string> instructions;  ///< empty: the instruction set that a run uses
  std::vector<std::string> formulations = known_formulations();
  std::vector<int> dimensions = {2};
  std::vector<std::string> mixings = {std::string(name_of(Mixing::series))};
  double seconds = 10.0;
  int rounds = 7;
  bool processor_time = false;
  bool json = false;
};

std::vector<int> threads_of(const BenchArguments& arguments) {
  if (!arguments.threads.empty()) return arguments.threads;
  const int cores = this_machine().cores;
  if (parallel::ranks() > 1 || cores == 1) return {1};
  return {1, cores};
}

/// The numbers of points for a formulation. The classical one, by far the slowest, has the small number by default.
std::vector<double> points_of(const BenchArguments& arguments, Formulation formulation) {
  constexpr double few = 1e5, many = 1e6;
  if (!arguments.points.empty()) return arguments.points;
  if (formulation == Formulation::classical) return {few};
  return {few, many};
}

std::vector<InstructionSet> instructions_of(const BenchArguments& arguments) {
  if (arguments.instructions.empty()) return {chosen_instruction_set()};
  std::vector<InstructionSet> sets;
  std::ranges::copy_if(supported_instruction_sets(), std::back_inserter(sets), [&](InstructionSet set) {
    return std::ranges::find(arguments.instructions, name_of(set)) != arguments.instructions.end();
  });
  return sets;
}

bool wants(const BenchArguments& arguments, Formulation formulation) {
  return std::ranges::find(arguments.formulations, name_of(formulation)) != arguments.formulations.end();
}

/// Cells along each side for about so many points.
int cells_along(double points, int dimensions) {
  const double cells =
      dimensions == 3 ? std::cbrt(points / CellShape<3>::points) : std::sqrt(points / CellShape<2>::points);
  return static_cast<int>(std::lround(cells));
}

/// All combinations of the settings; the classical formulation does not depend on the instruction set.
std::vector<KernelCase> cases_of(const BenchArguments& arguments) {
  std::vector<KernelCase> cases;
  const auto add = [&](Formulation formulation, InstructionSet instructions) {
    for (const double points : points_of(arguments, formulation)) {
      for (const int dimensions : arguments.dimensions) {
        const int cells = cells_along(points, dimensions);
        for (const int terms : arguments.terms) {
          for (const int threads : threads_of(arguments)) {
            for (const auto& mixing : arguments.mixings) {
              cases.push_back(
                  {formulation, instructions, cells, terms, threads, value_named<Mixing>(mixing).value(), dimensions});
            }
          }
        }
      }
    }
  };
  if (wants(arguments, Formulation::total_lagrangian)) {
    for (const auto set : instructions_of(arguments)) add(Formulation::total_lagrangian, set);
  }
  if (wants(arguments, Formulation::classical)) add(Formulation::classical, InstructionSet::baseline);
  return cases;
}

void run_bench(const BenchArguments& arguments) {
  watch_for_interruption();
  ProgressLine progress(!parallel::is_first());
  const BenchmarkPlan plan = {cases_of(arguments), arguments.seconds, arguments.rounds,
                              arguments.processor_time ? Clock::processor : Clock::wall};
  const auto result = run_benchmark(plan, [&](double share) {
    stop_if_interrupted();
    progress.update("bench", share, fmt::format("{} cases", plan.cases.size()));
  });
  progress.print(arguments.json ? json_of(result) : table_of(result));
}

std::vector<std::string> names_of(const std::vector<InstructionSet>& sets) {
  std::vector<std::string> names;
  names.reserve(sets.size());
  for (const auto set : sets) names.emplace_back(name_of(set));
  return names;
}

/// The type of an option that takes one or more of these words, as its help shows it.
std::string one_or_more_of(const std::vector<std::string>& words) {
  return fmt::format("{} ...", fmt::join(words, "|"));
}

}  // namespace

void add_bench(CLI::App& application) {
  auto* command = application.add_subcommand("bench", "measure the speed of the explicit method on this machine");
  auto arguments = std::make_shared<BenchArguments>();
  command
      ->add_option("--points", arguments->points,
                   "approximate number of material points (default: 1e5 1e6; classical formulation: 1e5)")
      ->type_name("N ...")
      ->check(CLI::Range(64.0, 1e9).description(""));
  command->add_option("--terms", arguments->terms, "number of Prony terms of the matrix (default: 0 1 5 10)")
      ->type_name("N ...")
      ->check(CLI::Range(0, 100).description(""));
  command
      ->add_option("--threads", arguments->threads,
                   "number of threads (default: 1 and one for each core; under mpirun 1)")
      ->type_name("N ...")
      ->check(CLI::Range(1, 1024).description(""));
  command
      ->add_option("--instructions", arguments->instructions,
                   "instruction sets of the total-lagrangian formulation (default: the one that a run uses)")
      ->type_name(one_or_more_of(names_of({InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})))
      ->check(CLI::IsMember(names_of(supported_instruction_sets())).description(""));
  command->add_option("--formulation", arguments->formulations, "formulations to measure (default: both)")
      ->type_name(one_or_more_of(known_formulations()))
      ->check(CLI::IsMember(known_formulations()).description(""));
  command->add_option("--dimensions", arguments->dimensions, "dimensions of the box: 2 (the default), 3, or both")
      ->type_name("2|3 ...")
      ->check(CLI::IsMember(std::vector<int>{2, 3}).description(""));
  command
      ->add_option("--mixing", arguments->mixings,
                   "cells along interfaces: series (mixed cells, the default), points, or both")
      ->type_name("series|points ...")
      ->check(CLI::IsMember(std::vector<std::string>{"series", "points"}).description(""));
  command
      ->add_option("--seconds", arguments->seconds, "approximate time of all measurements together, in s (default: 10)")
      ->type_name("S")
      ->check(CLI::Range(0.01, 1e5).description(""));
  command
      ->add_option("--rounds", arguments->rounds,
                   "number of measurements of each case, whose median is printed (default: 7)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description(""));
  command->add_flag("--processor-time", arguments->processor_time,
                    "measure processor time instead of wall time, for a machine that is shared");
  command->add_flag("--json", arguments->json, "print JSON with every measurement instead of a table");
  command->callback([arguments] { run_bench(*arguments); });
}

}  // namespace breccia::cli
