#include "breccia/quasistatic/log_time_stepping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/discretisation/point_fields_state.hpp"
#include "breccia/error.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/quasistatic/linear_effort_state.hpp"

#include "operator/displacement_state.hpp"
#include "operator/recovery.hpp"
#include "solvers/elastic_solver.hpp"
#include "stepping/log_time_integrator.hpp"

namespace breccia {
namespace {

using quasistatic::ElasticOperator;
using quasistatic::ElasticSolver;
using quasistatic::LogTimeIntegrator;
using quasistatic::RelaxingModulus;

/// The integration of all loads over one list of times.
class TimeSteppingRun {
 public:
  TimeSteppingRun(const QuasistaticProblem& problem, const ElasticOperator<2>& elastic_operator,
                  std::span<const Load> loads, std::vector<double> times)
      : materials_(&problem.materials),
        relaxing_(quasistatic::relaxing_moduli(problem.materials)),
        times_(std::move(times)),
        values_(loads.size()) {
    for (const auto load : loads) loads_.emplace_back(elastic_operator, problem.materials, relaxing_, load);
  }
  TimeSteppingRun(const TimeSteppingRun&) = delete;
  TimeSteppingRun& operator=(const TimeSteppingRun&) = delete;
  TimeSteppingRun(TimeSteppingRun&&) = delete;
  TimeSteppingRun& operator=(TimeSteppingRun&&) = delete;
  ~TimeSteppingRun() = default;

  [[nodiscard]] bool is_over() const noexcept { return taken_ == times_.size() + 1; }
  [[nodiscard]] double share() const { return static_cast<double>(taken_) / static_cast<double>(times_.size() + 1); }
  /// The time that has been reached [s]; 0 right after the jump, which is the first step.
  [[nodiscard]] double time() const { return taken_ < 2 ? 0.0 : times_[taken_ - 2]; }
  [[nodiscard]] const LogTimeIntegrator& first_load() const { return loads_.front(); }
  /// By load: the value right after the jump, then the values at the times.
  [[nodiscard]] const std::vector<std::vector<double>>& values() const noexcept { return values_; }

  void step(ElasticSolver& solver) {
    const double time_step = taken_ == 0 ? 0.0 : times_[taken_ - 1] - time();
    std::vector<Moduli> algorithmic;
    for (const auto& material : *materials_) {
      algorithmic.push_back({quasistatic::algorithmic_modulus(material.bulk, time_step),
                             quasistatic::algorithmic_modulus(material.shear, time_step)});
    }
    solver.set_moduli(algorithmic);
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      values_[i].push_back(loads_[i].step(time_step, algorithmic, solver));
    }
    ++taken_;
  }

  /// Saves the values and, unless the run is over, the state from which it continues.
  void save(StateWriter& state, const std::string& group) const {
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      const auto of_load = fmt::format("{}/{}", group, i);
      state.write(of_load + "/values", values_[i]);
      if (!is_over()) loads_[i].save(state, of_load);
    }
  }
  void restore(const StateReader& state, const std::string& group) {
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      const auto of_load = fmt::format("{}/{}", group, i);
      values_[i] = state.numbers(of_load + "/values");
      taken_ = values_[i].size();
      if (!is_over()) loads_[i].restore(state, of_load);
    }
  }

 private:
  const std::vector<Material>* materials_;
  std::vector<RelaxingModulus> relaxing_;
  std::vector<double> times_;
  std::vector<LogTimeIntegrator> loads_;
  std::vector<std::vector<double>> values_;
  std::size_t taken_ = 0;  ///< steps taken, the jump included
};

/// Every other time, and the last one.
std::vector<std::size_t> every_other(std::size_t count) {
  std::vector<std::size_t> coarse;
  for (std::size_t i = 1; i < count; i += 2) coarse.push_back(i);
  if (count % 2 == 1) coarse.push_back(count - 1);
  return coarse;
}

/// Relative errors of the fine run. The method is of second order, so the error of the fine run is a third of its
/// difference to the coarse run. A time between two times of the coarse run takes the larger of their estimates.
std::vector<double> error_estimates(const std::vector<double>& fine, const std::vector<double>& coarse,
                                    const std::vector<std::size_t>& places) {
  std::vector<double> errors(fine.size(), 0.0);
  for (std::size_t c = 0; c < places.size(); ++c) {
    const double error = std::abs(coarse[c] / fine[places[c]] - 1.0) / 3.0;
    const std::size_t before = c == 0 ? 0 : places[c - 1] + 1;
    const std::size_t behind = c + 1 == places.size() ? fine.size() : places[c + 1];
    for (std::size_t i = before; i < behind; ++i) errors[i] = std::max(errors[i], error);
  }
  return errors;
}

void require_complete(const QuasistaticProblem& problem, std::span<const double> times) {
  if (times.empty() || !(times.front() > 0.0) || !std::is_sorted(times.begin(), times.end())) {
    throw InputError("log-time stepping: expected rising positive times");
  }
  for (const auto& cell : problem.discretisation.cells()) {
    for (const auto material : cell) {
      if (material == no_phase || material < problem.materials.size()) continue;
      throw InputError(
          fmt::format("log-time stepping: a point has material {} of {}", material, problem.materials.size()));
    }
  }
}

}  // namespace

SteppingResult run_log_time_stepping(const QuasistaticProblem& problem, std::span<const Load> loads,
                                     std::span<const double> times, const ShareObserver& observer,
                                     std::span<const double> field_times, Checkpoint* checkpoint) {
  require_complete(problem, times);
  const ElasticOperator<2> elastic_operator(problem.discretisation, problem.volumetric, problem.boundary);
  const auto solver = quasistatic::make_elastic_solver(elastic_operator, problem.linear);
  const auto places = every_other(times.size());
  std::vector<double> coarse_times;
  coarse_times.reserve(places.size());
  for (const auto place : places) coarse_times.push_back(times[place]);
  TimeSteppingRun fine(problem, elastic_operator, loads, {times.begin(), times.end()});
  TimeSteppingRun coarse(problem, elastic_operator, loads, coarse_times);

  SteppingResult result;
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    quasistatic::require_as_many_processes(*earlier);
    fine.restore(*earlier, "/fine");
    coarse.restore(*earlier, "/coarse");
    result.fields = read_fields(*earlier, "/fields", problem.discretisation);
    solver->restore_preconditioner(*earlier, "/preparation");
    solver->count_from(read_effort(*earlier, "/effort"));
  }
  const auto save_if_due = [&] {
    if (checkpoint == nullptr || !checkpoint->is_due()) return;
    checkpoint->save([&](StateWriter& state) {
      state.write("/processes", std::int64_t{parallel::ranks()});
      fine.save(state, "/fine");
      coarse.save(state, "/coarse");
      save(state, "/fields", result.fields);
      solver->save_preconditioner(state, "/preparation");
      save(state, "/effort", solver->effort());
    });
  };

  constexpr double share_of_fine = 2.0 / 3.0;
  while (!fine.is_over()) {
    save_if_due();
    fine.step(*solver);
    if (std::find(field_times.begin(), field_times.end(), fine.time()) != field_times.end()) {
      const auto& first = fine.first_load();
      result.fields.push_back(
          {fine.time(), recover_fields(elastic_operator, problem.discretisation, problem.volumetric, loads.front(),
                                       first.displacement(), first.applied_moduli())});
    }
    if (observer) observer(share_of_fine * fine.share());
  }
  while (!coarse.is_over()) {
    save_if_due();
    coarse.step(*solver);
    if (observer) observer(share_of_fine + (1.0 - share_of_fine) * coarse.share());
  }

  result.effort = solver->effort();
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const auto after_jump = [](const std::vector<double>& values) {
      return std::vector(values.begin() + 1, values.end());
    };
    const auto values = after_jump(fine.values()[l]);
    result.responses.push_back(
        {loads[l], fine.values()[l].front(), values, error_estimates(values, after_jump(coarse.values()[l]), places)});
  }
  return result;
}

}  // namespace breccia
