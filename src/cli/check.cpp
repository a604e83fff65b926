#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/available_memory.hpp"
#include "breccia/homogenisation/film_estimate.hpp"
#include "breccia/homogenisation/grid_estimate.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/process_share.hpp"
#include "breccia/homogenisation/quasistatic_time.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_warnings.hpp"
#include "breccia/homogenisation/test_requests.hpp"
#include "breccia/io/display.hpp"
#include "breccia/io/percentage.hpp"
#include "breccia/study/chain.hpp"
#include "breccia/study/test_rules.hpp"

#include "command.hpp"
#include "filler_summary.hpp"
#include "summary.hpp"
#include "sweep_summary.hpp"

namespace breccia::cli {
namespace {

/// The estimated time and memory of tests, with the lines to be printed.
struct Plan {
  std::string text = {};
  double seconds = 0.0;
  double bytes = 0.0;       ///< memory of the largest test [B]
  ProcessShare share = {};  ///< of each of several processes

  void add(const Plan& further) {
    text += further.text;
    seconds += further.seconds;
    bytes = std::max(bytes, further.bytes);
    share.seconds += further.share.seconds;
    share.bytes = std::max(share.bytes, further.share.bytes);
    share.common_bytes = std::max(share.common_bytes, further.share.common_bytes);
  }
};

std::string memory(double bytes) {
  return display(bytes, "B");
}

/// The plan of a test on a grid with `cells` cells per side, from the same test on a grid that is no finer.
template <int dim>
Plan dynamic_plan(const Stage& stage, const DynamicTest<dim>& test, int cells, int processes) {
  const auto plan = plan_dynamic_test(test, static_cast<double>(cells) / test.discretisation.grid().cells[0]);
  const double speed = trial_speed(test);
  const auto points = point_count(stage, cells);
  const auto bytes = static_cast<double>(plan.bytes);
  std::int64_t steps = 0;
  auto text = fmt::format("  {} {}, {}, dynamic: {} points, about {}\n", stage.name, name_of(test.load),
                          bound_of(test.boundary), points, memory(bytes));
  for (const auto& domain : plan.domains) {
    steps += domain.steps;
    text += fmt::format("    density x {:<8.3g} valid {:.3g} to {:.3g} s, {} steps of {:.3g} s, {}\n",
                        domain.mass_scaling, domain.window.begin, domain.window.end, domain.steps, domain.time_step,
                        display_count(static_cast<std::size_t>(domain.terms), "term"));
  }
  const double seconds = static_cast<double>(points) * static_cast<double>(steps) / speed;
  text += fmt::format("    together {} steps, about {} at {:.0f} million points x steps/s here\n", steps,
                      display_duration(seconds), speed / 1e6);
  const auto share = test.options.formulation == Formulation::classical
                         ? classical_share(dim, cells, bytes, seconds)
                         : dynamic_share(dim, cells, bytes, seconds, processes);
  return {text, seconds, bytes, share};
}

Plan quasistatic_plan(const Study& study, const Stage& stage, Boundary boundary, int cells, int processes) {
  const double unknowns = quasistatic_unknowns(stage, cells);
  const double bytes = quasistatic_memory(study, stage, cells);
  const double seconds = quasistatic_time(study, stage, boundary, cells);
  return {fmt::format("  {} {}, quasi-static: {} cells, {:.0f} unknowns, about {}, some {}\n", stage.name,
                      bound_of(boundary), cells_in_words(stage, cells), unknowns, memory(bytes),
                      display_duration(seconds, 1)),
          seconds, bytes, quasistatic_share(study, stage, boundary, cells, processes)};
}

Plan plan_of(const Study& study, const Stage& stage, const StageMicrostructure& packed, Method method, int cells,
             int processes) {
  Plan plan;
  for (const auto boundary : study.tests.boundaries) {
    if (method == Method::quasistatic) {
      plan.add(quasistatic_plan(study, stage, boundary, cells, processes));
      continue;
    }
    // A finer grid is planned by this one, which takes some 20 MB a Prony term: its points would take long, and memory
    // that may not be there.
    const int most_planned = stage.dimensions() == 3 ? 48 : 1000;
    const auto matrix = expected_matrix(study, stage);
    const auto add_loads = [&](const auto& discretisation) {
      for (const auto load : loads_of(study, stage)) {
        const auto test = make_dynamic_test(study, stage, matrix, discretisation, boundary, load, 0);
        plan.add(dynamic_plan(stage, test, cells, processes));
      }
    };
    std::visit(add_loads, discretise(stage, packed, std::min(cells, most_planned), study.tests.mixing));
  }
  return plan;
}

/// The plan of a test of grains and films.
Plan film_plan(const Study& study, const Stage& stage, const GrainStatistics& placed, Boundary boundary,
               int processes) {
  const auto grains = placed_grains(stage, placed);
  const double bytes = film_memory(study, stage, grains), seconds = film_time(study, stage, grains);
  return {fmt::format("  {} {}, quasi-static: {} grains and films, {:.0f} unknowns, about {}, some {}\n", stage.name,
                      bound_of(boundary), placed.count, film_unknowns(study.tests, grains), memory(bytes),
                      display_duration(seconds, 1)),
          seconds, bytes, film_share(study, stage, grains, processes)};
}

Plan plan_of(const Study& study, const Stage& stage, const StageMicrostructure& packed, int processes) {
  Plan plan;
  if (model_of(study.tests, stage) == Model::films) {
    for (const auto boundary : study.tests.boundaries) {
      plan.add(film_plan(study, stage, *packed.grains(), boundary, processes));
    }
    return plan;
  }
  for (const int cells : stage.grids()) {
    for (const auto method : study.tests.methods) plan.add(plan_of(study, stage, packed, method, cells, processes));
  }
  return plan;
}

/// The lines with the total of all tests.
std::string total(const Study& study, const Plan& plan, int processes) {
  const bool is_quasistatic = std::ranges::count(study.tests.methods, Method::dynamic) == 0;
  auto text = fmt::format("together about {}{}, at most {} of memory\n", display_duration(plan.seconds),
                          is_quasistatic ? " on one core" : "", memory(plan.bytes));
  if (processes == 1) return text;
  const auto& [bytes, seconds, common] = plan.share;
  const auto of_machine =
      common > 0.0 ? fmt::format(" and {} more that a machine holds once", memory(common)) : std::string();
  return text + fmt::format("on {} processes with a core each about {}, at most {} of memory a process{}\n", processes,
                            display_duration(seconds), memory(bytes), of_machine);
}

/// A length of the microstructure of which the cells tell the error of a grid.
struct TellingLength {
  double length;                                                       ///< [m]
  std::string_view place;                                              ///< of cells: "in the narrowest gap"
  std::function<std::optional<double>(double cells)> error_with = {};  ///< [-]; empty where no rule is known
  std::function<double(double error)> cells_for = {};
  std::string_view without_rule = "points in three dimensions";  ///< of what no rule is known
};

/// The length that tells the error of a stage of particles or grains.
TellingLength telling_length(const Stage& stage, const StageMicrostructure& packed, Mixing mixing) {
  const double gap = std::min(packed.gap, packed.wall_gap);
  if (packed.grains() != nullptr) {
    // Between grains no rule is known for points, which take far more cells.
    if (mixing == Mixing::points) return {gap, "across a film"};
    return {gap, "across a film", expected_film_error, cells_per_film_for};
  }
  if (stage.dimensions() == 3) {
    constexpr auto in_a_gap = "in the narrowest gap";
    if (mixing == Mixing::points) return {gap, in_a_gap};
    if (packed.content<Microstructure<3>>() == nullptr) return {gap, in_a_gap, {}, {}, "ellipsoids"};
    const double fraction = packed.fraction, diameter = packed.mean_diameter();
    const auto* across_a_sphere =
        is_sphere_error_measured(fraction)
            ? "across the mean sphere"
            : "across the mean sphere, by a rule that is extrapolated from 30 to 50 % of spheres";
    if (!cells_per_diameter_for(0.1, fraction)) return {diameter, across_a_sphere, {}, {}, "spheres close to jamming"};
    return {diameter, across_a_sphere, [fraction](double cells) { return expected_sphere_error(cells, fraction); },
            [fraction](double error) { return *cells_per_diameter_for(error, fraction); }};
  }
  return {gap, "in the narrowest gap", [mixing](double cells) { return expected_grid_error(mixing, cells); },
          [mixing](double error) { return cells_per_gap_for(mixing, error); }};
}

/// The cells per side of a stage for errors of these sizes [-]; empty where no length tells.
std::string grid_advice(const Stage& stage, const StageMicrostructure& packed, Mixing mixing,
                        const std::vector<double>& errors) {
  const auto [length, place, error_with, cells_for, without_rule] = telling_length(stage, packed, mixing);
  const bool is_extrapolated = mixing == Mixing::points && !stage.coarser_cells.empty();
  const bool has_no_rule = packed.grains() != nullptr && mixing == Mixing::points;
  if (!std::isfinite(length) || !(length > 0.0) || is_extrapolated || has_no_rule) return {};
  const double cells = length / stage.cell_size();
  const auto shown = fmt::format("{:.2g}", cells);
  const auto width = fmt::format("{} {} {}", shown, shown == "1" ? "cell" : "cells", place);
  if (!error_with) {
    return fmt::format("  {}: {}; no rule tells the error of the grid for {}\n", stage.name, width, without_rule);
  }
  std::vector<std::string> advice;
  for (const double error : errors) {
    const double per_side = std::ceil(cells_for(error) * stage.side / length);
    advice.push_back(fmt::format("{:.0f} for {:.2g} %", per_side, 100.0 * error));
  }
  const auto expected = error_with(cells);
  return fmt::format("  {}: {}, error of the grid {}; cells = {}\n", stage.name, width,
                     expected ? fmt::format("up to about {:.2g} %", 100.0 * *expected) : "of any size",
                     fmt::join(advice, ", "));
}

void print_plan(const Study& study, const std::vector<double>& errors, int processes) {
  fmt::print("{}\nplan, with an estimate of the composite's modulus (a run computes it and may need less)\n",
             summary(study));
  Plan all;
  std::vector<std::vector<FillerStatistics>> fillers;
  for (const auto& stage : study.stages) {
    const auto packed = make_microstructure(stage);
    fillers.push_back(packed.fillers);
    const auto plan = plan_of(study, stage, packed, processes);
    const bool has_grid = model_of(study.tests, stage) == Model::cells;
    fmt::print("{}{}", plan.text, has_grid ? grid_advice(stage, packed, study.tests.mixing, errors) : "");
    for (const auto& warning : warnings_on(study, stage, packed)) fmt::print("warning: {}\n", warning);
    all.add(plan);
  }
  fmt::print("{}", filler_summary(study, fillers));
  fmt::print("{}", total(study, all, processes));
  // What several processes take may be the memory of several machines.
  if (processes == 1) require_memory(study, available_memory());
}

/// The errors that the option --error names [-]. Throws InputError for one that is no percentage of less than 100 %.
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
  struct Arguments {
    DeckArguments deck;
    std::vector<std::string> errors;
    int processes = 1;
  };
  auto arguments = std::make_shared<Arguments>();
  add_deck_arguments(*command, arguments->deck);
  command
      ->add_option("--error", arguments->errors,
                   R"(tell the cells for these errors of the modulus (default: "5 %" "2 %" "1 %"))")
      ->type_name("SHARE ...");
  command
      ->add_option("--processes", arguments->processes,
                   "tell the memory and the time of each of N processes under mpirun, too")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20).description(""));
  command->callback([arguments] {
    const auto errors = errors_of(arguments->errors);
    const auto sweep = arguments->deck.read();
    if (!sweep.keys.empty()) {
      fmt::print("a sweep of {} tasks\n\n{}\nthe first one:\n\n", sweep.tasks.size(), table_of_tasks(sweep));
    }
    print_plan(sweep.tasks.front().study, errors, arguments->processes);
  });
}

}  // namespace breccia::cli
