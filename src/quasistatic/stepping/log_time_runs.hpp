#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "checkpoint/checkpoint.hpp"
#include "quasistatic/stepping/log_time_integrator.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia::quasistatic {

/// The integration of all loads over one list of times. The composite and the series of its parts must outlive it.
template <SteppableComposite Composite>
class LogTimeRun {
 public:
  using Vector = typename Composite::Vector;

  LogTimeRun(const Composite& composite, const std::vector<const PronySeries*>& series, std::span<const Load> loads,
             std::vector<double> times)
      : series_(&series), times_(std::move(times)), values_(loads.size()) {
    for (const auto load : loads) loads_.emplace_back(composite, series, load);
  }

  [[nodiscard]] bool is_over() const noexcept { return taken_ == times_.size() + 1; }
  [[nodiscard]] double share() const { return static_cast<double>(taken_) / static_cast<double>(times_.size() + 1); }
  /// The time that has been reached [s]; 0 right after the jump, which is the first step.
  [[nodiscard]] double time() const { return taken_ < 2 ? 0.0 : times_[taken_ - 2]; }
  [[nodiscard]] const LogTimeIntegrator<Composite>& first_load() const { return loads_.front(); }
  /// The values for each load: first that right after the jump, then those at the times.
  [[nodiscard]] const std::vector<std::vector<double>>& values() const noexcept { return values_; }

  template <StepSolver<Vector> Solver>
  void step(Solver& solver) {
    const double time_step = taken_ == 0 ? 0.0 : times_[taken_ - 1] - time();
    std::vector<double> algorithmic;
    for (const auto* modulus : *series_) algorithmic.push_back(algorithmic_modulus(*modulus, time_step));
    solver.take(algorithmic);
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
  /// Restores a saved run. Throws FileError for values of more steps than there are times, and when loads differ in the
  /// number of steps.
  void restore(const StateReader& state, const std::string& group) {
    taken_ = state.numbers(fmt::format("{}/0/values", group)).size();
    if (taken_ > times_.size() + 1) {
      throw FileError(
          fmt::format("{}: the values of {} steps, expected {} at most", state.path(), taken_, times_.size() + 1));
    }
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      const auto of_load = fmt::format("{}/{}", group, i);
      values_[i] = state.numbers(of_load + "/values", taken_);
      if (!is_over()) loads_[i].restore(state, of_load);
    }
  }

 private:
  const std::vector<const PronySeries*>* series_;
  std::vector<double> times_;
  std::vector<LogTimeIntegrator<Composite>> loads_;
  std::vector<std::vector<double>> values_;
  std::size_t taken_ = 0;  ///< steps taken, the jump included
};

/// The indices of every other one of so many times, and of the last one.
[[nodiscard]] std::vector<std::size_t> every_other(std::size_t count);

/// Values at some indices of a list.
[[nodiscard]] std::vector<double> at_indices(std::span<const double> values, const std::vector<std::size_t>& indices);

/// The response to a load from the values right after the jump and at the times, and from those of a run over the times
/// at some indices, by which the error is estimated.
[[nodiscard]] SteppedResponse stepped_response(Load load, const std::vector<double>& fine,
                                               const std::vector<double>& coarse,
                                               const std::vector<std::size_t>& indices);

/// Throws InputError unless there are loads and rising positive times.
void require_steps(std::span<const Load> loads, std::span<const double> times);

/// A composite at a time of a run [s].
template <class Vector>
struct TimedState {
  double time = 0.0;
  CompositeState<Vector> state;
};

/// The run over all times, and the run over every other time, from whose difference the error is estimated. Keeps the
/// states of the first load at some times. The composite and the series of its parts must outlive it.
template <SteppableComposite Composite>
class LogTimeRuns {
 public:
  using Vector = typename Composite::Vector;

  LogTimeRuns(const Composite& composite, const std::vector<const PronySeries*>& series, std::span<const Load> loads,
              std::span<const double> times, std::span<const double> kept_times)
      : composite_(&composite),
        loads_(loads.begin(), loads.end()),
        kept_times_(kept_times.begin(), kept_times.end()),
        steps_(times.size()),
        indices_(every_other(times.size())),
        fine_(composite, series, loads, {times.begin(), times.end()}),
        coarse_(composite, series, loads, at_indices(times, indices_)) {}

  [[nodiscard]] bool is_over() const noexcept { return fine_.is_over() && coarse_.is_over(); }
  [[nodiscard]] Progress progress() const {
    constexpr double share_of_fine = 2.0 / 3.0;
    return {.share = share_of_fine * fine_.share() + (1.0 - share_of_fine) * coarse_.share(),
            .details = fmt::format("{} steps", steps_)};
  }

  /// Takes the next step.
  template <StepSolver<Vector> Solver>
  void step(Solver& solver) {
    if (fine_.is_over()) {
      coarse_.step(solver);
      return;
    }
    fine_.step(solver);
    if (std::ranges::find(kept_times_, fine_.time()) == kept_times_.end()) return;
    kept_.push_back({fine_.time(), fine_.first_load().state()});
  }

  [[nodiscard]] const std::vector<TimedState<Vector>>& kept() const noexcept { return kept_; }
  [[nodiscard]] std::vector<SteppedResponse> responses() const {
    std::vector<SteppedResponse> responses;
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      responses.push_back(stepped_response(loads_[l], fine_.values()[l], coarse_.values()[l], indices_));
    }
    return responses;
  }

  void save(StateWriter& state) const {
    fine_.save(state, "/fine");
    coarse_.save(state, "/coarse");
    state.write("/kept/count", static_cast<std::int64_t>(kept_.size()));
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const auto group = fmt::format("/kept/{}", i);
      state.write(group + "/time_s", kept_[i].time);
      save_vector(state, group + "/displacement", kept_[i].state.displacement);
      const auto& applied = kept_[i].state.applied;
      state.write(group + "/parts", static_cast<std::int64_t>(applied.size()));
      for (std::size_t part = 0; part < applied.size(); ++part) {
        save_vector(state, fmt::format("{}/applied/{}", group, part), applied[part]);
      }
    }
  }
  void restore(const StateReader& state) {
    fine_.restore(state, "/fine");
    coarse_.restore(state, "/coarse");
    const auto count = state.integer("/kept/count");
    for (std::int64_t i = 0; i < count; ++i) {
      const auto group = fmt::format("/kept/{}", i);
      auto& [time, kept] =
          kept_.emplace_back(TimedState<Vector>{state.number(group + "/time_s"), {composite_->zero(), {}}});
      restore_vector(state, group + "/displacement", kept.displacement);
      const auto parts = state.integer(group + "/parts");
      for (std::int64_t part = 0; part < parts; ++part) {
        restore_vector(state, fmt::format("{}/applied/{}", group, part), kept.applied.emplace_back(composite_->zero()));
      }
    }
  }

 private:
  const Composite* composite_;
  std::vector<Load> loads_;
  std::vector<double> kept_times_;
  std::size_t steps_;
  std::vector<std::size_t> indices_;  ///< indices of the times of the coarse run among all times
  LogTimeRun<Composite> fine_;
  LogTimeRun<Composite> coarse_;
  std::vector<TimedState<Vector>> kept_;
};

/// Takes all steps. With a checkpoint, the state is saved between steps when that is due: save_others(state) adds the
/// data that the caller needs to continue.
template <SteppableComposite Composite, StepSolver<typename Composite::Vector> Solver, class SaveOthers>
void take_all_steps(LogTimeRuns<Composite>& runs, Solver& solver, const ProgressObserver& observer,
                    Checkpoint* checkpoint, const SaveOthers& save_others) {
  while (!runs.is_over()) {
    if (checkpoint != nullptr && checkpoint->is_due()) {
      checkpoint->save([&](StateWriter& state) {
        save_others(state);
        runs.save(state);
      });
    }
    runs.step(solver);
    if (observer) observer(runs.progress());
  }
}

}  // namespace breccia::quasistatic
