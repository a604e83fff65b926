#include "breccia/quasistatic/log_time_stepping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
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
template <int dim>
class TimeSteppingRun {
 public:
  TimeSteppingRun(const QuasistaticProblem<dim>& problem, const ElasticOperator<dim>& elastic_operator,
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
  [[nodiscard]] const LogTimeIntegrator<dim>& first_load() const { return loads_.front(); }
  /// By load: the value right after the jump, then the values at the times.
  [[nodiscard]] const std::vector<std::vector<double>>& values() const noexcept { return values_; }

  void step(ElasticSolver<dim>& solver) {
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
  std::vector<LogTimeIntegrator<dim>> loads_;
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

/// Values at some places of a list.
std::vector<double> at_places(std::span<const double> values, const std::vector<std::size_t>& places) {
  std::vector<double> chosen;
  chosen.reserve(places.size());
  for (const auto place : places) chosen.push_back(values[place]);
  return chosen;
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

template <int dim>
void require_complete(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                      std::span<const double> times) {
  const auto is_time = [](double time) { return time > 0.0 && std::isfinite(time); };
  const auto rises = [](double before, double after) { return before < after; };
  if (times.empty() || !std::ranges::all_of(times, is_time) ||
      std::ranges::adjacent_find(times, std::not_fn(rises)) != times.end()) {
    throw InputError("log-time stepping: expected rising positive times");
  }
  if (loads.empty()) throw InputError("log-time stepping: no loads");
  require_loads("log-time stepping", dim, loads);
  require_phases_in_cells("log-time stepping", problem.discretisation, problem.materials.size());
}

/// The run over all times, and the run over every other time, from whose difference the error is estimated.
template <int dim>
class TwoRuns {
 public:
  TwoRuns(const QuasistaticProblem<dim>& problem, const ElasticOperator<dim>& elastic_operator,
          std::span<const Load> loads, std::span<const double> times)
      : problem_(&problem),
        elastic_operator_(&elastic_operator),
        loads_(loads),
        places_(every_other(times.size())),
        solver_(quasistatic::make_elastic_solver(elastic_operator, problem.linear)),
        fine_(problem, elastic_operator, loads, {times.begin(), times.end()}),
        coarse_(problem, elastic_operator, loads, at_places(times, places_)) {}

  [[nodiscard]] bool is_over() const noexcept { return fine_.is_over() && coarse_.is_over(); }
  /// Finished share of the work, 0 to 1.
  [[nodiscard]] double share() const {
    constexpr double share_of_fine = 2.0 / 3.0;
    return share_of_fine * fine_.share() + (1.0 - share_of_fine) * coarse_.share();
  }

  /// Takes the next step. Keeps the fields after it if its time is one of the field times [s].
  void step(std::span<const double> field_times) {
    if (fine_.is_over()) {
      coarse_.step(*solver_);
      return;
    }
    fine_.step(*solver_);
    if (std::find(field_times.begin(), field_times.end(), fine_.time()) == field_times.end()) return;
    const auto& first = fine_.first_load();
    fields_.push_back({fine_.time(), recover_fields(*elastic_operator_, problem_->discretisation, problem_->volumetric,
                                                    loads_.front(), first.displacement(), first.applied_moduli())});
  }

  void save(StateWriter& state) const {
    state.write("/processes", std::int64_t{parallel::ranks()});
    fine_.save(state, "/fine");
    coarse_.save(state, "/coarse");
    breccia::save(state, "/fields", fields_);
    solver_->save_preconditioner(state, "/preparation");
    breccia::save(state, "/effort", solver_->effort());
  }
  void restore(const StateReader& state) {
    quasistatic::require_as_many_processes(state);
    fine_.restore(state, "/fine");
    coarse_.restore(state, "/coarse");
    fields_ = read_fields(state, "/fields", problem_->discretisation);
    solver_->restore_preconditioner(state, "/preparation");
    solver_->count_from(read_effort(state, "/effort"));
  }

  /// Call it once, at the end.
  [[nodiscard]] SteppingResult<dim> result() {
    SteppingResult<dim> result = {{}, std::move(fields_), solver_->effort()};
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      const auto& fine = fine_.values()[l];
      const std::vector values(fine.begin() + 1, fine.end());
      const auto& coarse = coarse_.values()[l];
      result.responses.push_back(
          {loads_[l], fine.front(), values, error_estimates(values, {coarse.begin() + 1, coarse.end()}, places_)});
    }
    return result;
  }

 private:
  const QuasistaticProblem<dim>* problem_;
  const ElasticOperator<dim>* elastic_operator_;
  std::span<const Load> loads_;
  std::vector<std::size_t> places_;  ///< indices of the times of the coarse run among all times
  std::unique_ptr<ElasticSolver<dim>> solver_;
  TimeSteppingRun<dim> fine_;
  TimeSteppingRun<dim> coarse_;
  std::vector<TimedFields<dim>> fields_;
};

}  // namespace

template <int dim>
SteppingResult<dim> run_log_time_stepping(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                          std::span<const double> times, const ShareObserver& observer,
                                          std::span<const double> field_times, Checkpoint* checkpoint) {
  require_complete(problem, loads, times);
  const ElasticOperator<dim> elastic_operator(problem.discretisation, problem.volumetric, problem.boundary);
  TwoRuns<dim> runs(problem, elastic_operator, loads, times);
  if (checkpoint != nullptr && checkpoint->earlier() != nullptr) runs.restore(*checkpoint->earlier());
  while (!runs.is_over()) {
    if (checkpoint != nullptr && checkpoint->is_due()) {
      checkpoint->save([&](StateWriter& state) { runs.save(state); });
    }
    runs.step(field_times);
    if (observer) observer(runs.share());
  }
  return runs.result();
}

template SteppingResult<2> run_log_time_stepping(const QuasistaticProblem<2>&, std::span<const Load>,
                                                 std::span<const double>, const ShareObserver&, std::span<const double>,
                                                 Checkpoint*);
template SteppingResult<3> run_log_time_stepping(const QuasistaticProblem<3>&, std::span<const Load>,
                                                 std::span<const double>, const ShareObserver&, std::span<const double>,
                                                 Checkpoint*);

}  // namespace breccia
