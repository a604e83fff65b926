#include "breccia/homogenisation/plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/soundness.hpp"

#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/plan/cell_time.hpp"
#include "homogenisation/plan/expected_sample_error.hpp"
#include "homogenisation/plan/film_costs.hpp"
#include "homogenisation/plan/grid_error.hpp"
#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/plan/plan_remarks.hpp"
#include "homogenisation/plan/test_plans.hpp"
#include "homogenisation/stage_warnings.hpp"
#include "study/identity.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// A hash of everything that the packed box of a stage depends on.
std::string identity_of_box(const Stage& stage) {
  Study box;
  box.stages = {
      {.name = {}, .matrix = Material(), .side = stage.side, .fillers = stage.fillers, .packing = stage.packing}};
  for (auto& filler : box.stages.front().fillers) {
    filler.material = {};
    if (filler.coating) filler.coating->material = {};
  }
  return content_of(box);
}

/// Plans studies one after the other, and packs equal boxes once.
class Planner {
 public:
  explicit Planner(const ProgressObserver& follow) : follow_(follow) {}

  StudyPlan plan(const Study& study) {
    StudyPlan plan;
    for (const auto& stage : study.stages) plan.stages.push_back(plan_of_stage(study, stage));
    return plan;
  }

  /// Adds the plan of tasks that differ by seeds alone. As in a run of the sweep, a task that cannot be computed does
  /// not stop the other tasks. If the first box cannot be packed, the box of the next seed is tried; after two failures
  /// the plan assumes that no box of these tasks can be packed.
  void add(const Sweep& sweep, SweepPlan::Part part, SweepPlan& plan) {
    constexpr int most_attempts = 2;
    for (int attempt = 1;; ++attempt) {
      try {
        part.plan = this->plan(sweep.tasks[part.tasks.front()].study);
        part.failure.clear();
      } catch (const NumericalError& error) {
        part.failure = error.what();
        if (attempt < most_attempts && part.tasks.size() > 1) {
          plan.parts.push_back({{part.tasks.front()}, {}, part.failure});
          part.tasks.erase(part.tasks.begin());
          continue;
        }
      } catch (const InputError& error) {
        part.failure = error.what();
      }
      break;
    }
    plan.parts.push_back(std::move(part));
  }

 private:
  StagePlan plan_of_stage(const Study& study, const Stage& stage) {
    const auto& packed = box_of(stage);
    StagePlan plan = {
        .stage = stage.name,
        .sample_error = expected_sample_error(study, stage, packed.fillers, error_rules_of(study, stage, packed)),
        .fillers = packed.fillers,
        .warnings = warnings_on(study, stage, packed)};
    if (model_of(study.tests, stage) == Model::films) {
      for (const auto boundary : study.tests.boundaries) {
        plan.tests.push_back(plan_of_film_test(study, stage, boundary, *packed.grains()));
      }
      return plan;
    }
    auto as_computed = study;
    as_computed.tests.mixing = mixing_of(study, stage, packed);
    for (const int cells : stage.grids()) {
      for (const auto method : study.tests.methods) {
        std::ranges::move(plans_of_tests(as_computed, stage, packed, method, cells), std::back_inserter(plan.tests));
      }
    }
    plan.grid = plan_of_grid(study, stage, packed);
    plan.remarks = remarks_on_tests(as_computed, stage);
    return plan;
  }

  static std::vector<TestPlan> plans_of_tests(const Study& study, const Stage& stage, const StageMicrostructure& packed,
                                              Method method, int cells) {
    if (method == Method::dynamic) return plans_of_dynamic_tests(study, stage, packed, cells);
    std::vector<TestPlan> plans;
    for (const auto boundary : study.tests.boundaries) {
      plans.push_back(plan_of_quasistatic_test(study, stage, boundary, cells));
    }
    plans.front().seconds += discretisation_time(study, stage, cells);
    return plans;
  }

  const StageMicrostructure& box_of(const Stage& stage) {
    const auto identity = identity_of_box(stage);
    const auto known = boxes_.find(identity);
    return known != boxes_.end() ? known->second
                                 : boxes_.emplace(identity, make_microstructure(stage, follow_)).first->second;
  }

  const ProgressObserver& follow_;
  std::map<std::string, StageMicrostructure> boxes_;
};

/// Groups the tasks of a sweep: those in one part differ by seeds alone.
std::vector<SweepPlan::Part> parts_of(const Sweep& sweep, const std::vector<std::size_t>& tasks) {
  std::vector<SweepPlan::Part> parts;
  std::map<std::vector<std::string>, std::size_t> part_with;
  for (const auto task : tasks) {
    std::vector<std::string> values;
    for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
      if (!sweep.keys[key].is_seed) values.push_back(plain_text(sweep.tasks[task].values[key]));
    }
    const auto [part, is_new] = part_with.emplace(std::move(values), parts.size());
    if (is_new) parts.emplace_back();
    parts[part->second].tasks.push_back(task);
  }
  return parts;
}

std::vector<std::size_t> all_tasks(const Sweep& sweep) {
  std::vector<std::size_t> tasks;
  for (std::size_t task = 0; task < sweep.tasks.size(); ++task) tasks.push_back(task);
  return tasks;
}

/// Grains and films that need more than the available memory [B]: a message, with the number of grains that would fit.
std::vector<std::string> lacking_for_films(const Study& study, const Stage& stage, double available) {
  const auto grains = expected_grains(stage);
  const double bytes = film_memory(study, stage, grains);
  if (bytes <= available) return {};
  // Larger factors are in files, so that the needed memory does not grow steadily with the number of grains.
  double fitting = grains.count;
  constexpr double fewer = 0.999;
  while (fitting >= 1.0 && film_memory(study, stage, {fitting, grains.film, grains.dimensions}) > available) {
    fitting = std::floor(fewer * fitting);
  }
  return {fmt::format("{}: {:.0f} grains and films take about {:.3g} GB, and {:.3g} GB are left{}", stage.name,
                      grains.count, bytes / 1e9, available / 1e9,
                      fitting >= 1.0 ? fmt::format("; {:.0f} grains would fit", fitting) : "")};
}

std::vector<std::string> lacking_for_cells(const Study& study, const Stage& stage, double available) {
  std::vector<std::string> lines;
  for (const auto method : study.tests.methods) {
    const bool is_dynamic = method == Method::dynamic;
    const double bytes =
        is_dynamic ? memory_of_dynamic_tests(study, stage, stage.cells) : quasistatic_memory(study, stage, stage.cells);
    if (bytes <= available) continue;
    const double share = (available - measured_costs::program) / (bytes - measured_costs::program);
    const int fitting = static_cast<int>(stage.cells * std::pow(std::max(0.0, share), 1.0 / stage.dimensions()));
    lines.push_back(fmt::format("{}: {} cells take about {:.3g} GB by the {} method, and {:.3g} GB are left{}",
                                stage.name, cells_in_words(stage, stage.cells), bytes / 1e9,
                                is_dynamic ? "dynamic" : "quasi-static", available / 1e9,
                                fitting > 1 ? fmt::format("; cells = {} would fit", fitting) : ""));
  }
  return lines;
}

/// A message for every stage and method that needs more than the available memory [B].
std::vector<std::string> lacking_memory(const Study& study, double available) {
  std::vector<std::string> lines;
  for (const auto& stage : study.stages) {
    const bool has_films = model_of(study.tests, stage) == Model::films;
    std::ranges::move(has_films ? lacking_for_films(study, stage, std::max(0.0, available))
                                : lacking_for_cells(study, stage, std::max(0.0, available)),
                      std::back_inserter(lines));
  }
  return lines;
}

void refuse(const std::vector<std::string>& lines) {
  if (!lines.empty()) throw LackingMemory(fmt::format("{}", fmt::join(lines, "\n")));
}

}  // namespace

std::optional<double> ErrorRule::error_with(double cells) const {
  constexpr double rounding = 1e-9;
  if (cells < least_cells * (1.0 - rounding)) return std::nullopt;
  return error_of_one * std::pow(std::min(cells, most_cells), -order);
}

double ErrorRule::cells_for(double error) const {
  const double cells = std::max(least_cells, std::pow(error_of_one / error, 1.0 / order));
  return cells <= most_cells ? cells : std::numeric_limits<double>::infinity();
}

std::optional<double> GridPlan::error() const {
  const auto by_length = rule ? rule->error_with(cells()) : std::nullopt;
  return by_length ? std::optional(std::max(*by_length, interfaces * cell_size)) : std::nullopt;
}

std::optional<double> GridPlan::cells_for(double error) const {
  const double along = rule ? rule->cells_for(error) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(along)) return std::nullopt;
  return std::ceil(side * std::max(along / length, interfaces / error));
}

double StudyPlan::seconds() const {
  double sum = 0.0;
  for (const auto& stage : stages) {
    for (const auto& test : stage.tests) sum += test.seconds;
  }
  return sum;
}

double StudyPlan::bytes() const {
  double most = 0.0;
  for (const auto& stage : stages) {
    for (const auto& test : stage.tests) most = std::max(most, test.bytes);
  }
  return most;
}

double SweepPlan::seconds() const {
  double sum = 0.0;
  for (const auto& part : parts) sum += static_cast<double>(part.tasks.size()) * part.plan.seconds();
  return sum;
}

const SweepPlan::Part& SweepPlan::largest() const {
  return *std::ranges::max_element(parts, {}, [](const Part& part) { return part.plan.bytes(); });
}

StudyPlan plan_of(const Study& study, const ProgressObserver& follow) {
  require_sound(study);
  return Planner(follow).plan(study);
}

SweepPlan plan_of(const Sweep& sweep, const ProgressObserver& follow) {
  Planner planner(follow);
  SweepPlan plan;
  for (auto& part : parts_of(sweep, all_tasks(sweep))) planner.add(sweep, std::move(part), plan);
  std::ranges::sort(plan.parts, {}, [](const SweepPlan::Part& part) { return part.tasks.front(); });
  return plan;
}

std::optional<double> memory_of_factors(const Study& study, const StudyPlan& plan) {
  std::optional<double> most;
  for (std::size_t i = 0; i < study.stages.size(); ++i) {
    if (study.stages[i].dimensions() != 3 || !is_expected_to_have_flow(study, study.stages[i])) continue;
    for (const auto& test : plan.stages.at(i).tests) {
      most = std::max(most.value_or(0.0), measured_costs::factors_of_cube_with_flow * test.unknowns);
    }
  }
  return most;
}

double memory_of_process(double bytes, int processes) {
  return measured_costs::program + std::max(0.0, bytes - measured_costs::program) / processes;
}

void require_memory(const Study& study, double available) {
  refuse(lacking_memory(study, available));
}

void require_memory(const Sweep& sweep, const std::vector<std::size_t>& tasks, double available) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> tasks_of;  // in the order of tasks and stages
  for (const auto& part : parts_of(sweep, tasks)) {
    for (const auto& line : lacking_memory(sweep.tasks[part.tasks.front()].study, available)) {
      auto found = std::ranges::find(tasks_of, line, [](const auto& one) { return one.first; });
      if (found == tasks_of.end()) found = tasks_of.insert(found, {line, {}});
      found->second.insert(found->second.end(), part.tasks.begin(), part.tasks.end());
    }
  }
  std::vector<std::string> lines;
  for (const auto& [line, lacking] : tasks_of) {
    const auto& first = sweep.tasks[std::ranges::min(lacking)].name;
    const auto more = lacking.size() > 1 ? fmt::format(" and {} more", lacking.size() - 1) : "";
    lines.push_back(sweep.keys.empty() ? line : fmt::format("{}{}: {}", first, more, line));
  }
  refuse(lines);
}

void require_memory(const Sweep& sweep, double available) {
  require_memory(sweep, all_tasks(sweep), available);
}

}  // namespace breccia
