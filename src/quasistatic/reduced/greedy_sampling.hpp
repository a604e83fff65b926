#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "checkpoint/checkpoint.hpp"
#include "checkpoint/state.hpp"
#include "quasistatic/reduced/affine_composite.hpp"
#include "quasistatic/reduced/reduced_basis.hpp"
#include "quasistatic/reduced/residual_rounding.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/reduced/sampling_progress.hpp"
#include "quasistatic/reduced/target_curve.hpp"
#include "quasistatic/reduced/training_path.hpp"
#include "quasistatic/solvers/linear_effort_state.hpp"

namespace breccia::quasistatic {

[[nodiscard]] bool are_equal(std::span<const Moduli> some, std::span<const Moduli> others);

/// The candidate for the next snapshot: the moduli of the training set with the largest error estimate.
struct Candidate {
  std::vector<Moduli> moduli;  ///< moduli of the phases that vary [Pa]
  double estimate = -1.0;
};

/// The reduced basis of each load, which grows snapshot by snapshot by a greedy selection (theory, section 10). The
/// bases point to the composite, which must outlive this object.
template <AffineComposite Composite>
class GreedySampling {
 public:
  using Vector = typename Composite::Vector;

  GreedySampling(const Composite& composite, std::span<const Load> loads, const std::vector<Moduli>& reference)
      : composite_(&composite), scales_(loads.size(), 0.0), measured_(loads.size()) {
    for (const auto load : loads) bases_.emplace_back(composite, load, reference);
  }

  [[nodiscard]] const std::vector<ReducedBasis<Composite>>& bases() const noexcept { return bases_; }
  [[nodiscard]] int snapshots() const noexcept { return snapshots_; }
  /// Relative error at the last snapshot before it was added; 1 when it was not measured.
  [[nodiscard]] double error() const noexcept { return error_; }

  /// Adds the snapshot at these moduli to the basis of each load, without measuring the error there.
  template <CompositeSolver<Vector> Solver>
  void add_initial_snapshot(Solver& solver, const std::vector<Moduli>& at) {
    add_snapshot(solver, at, [](std::size_t, const Vector&) { return 0.0; });
    error_ = 1.0;
  }

  /// Measures the error of each reduced response at these moduli, and adds the snapshot.
  template <CompositeSolver<Vector> Solver>
  void add_selected_snapshot(Solver& solver, const std::vector<Moduli>& at, double tolerance) {
    add_snapshot(solver, at, [&](std::size_t load, const Vector& solution) {
      const double error = measure_error(load, solution, at, tolerance);
      error_ = load == 0 ? error : std::max(error_, error);
      return error;
    });
  }

  /// The number of loads whose bases have the next snapshot already; not zero where a run was ended between them.
  [[nodiscard]] std::size_t loads_done() const {
    const auto has_next = [this](const auto& of_load) { return of_load.size() > static_cast<std::size_t>(snapshots_); };
    return static_cast<std::size_t>(std::ranges::count_if(measured_, has_next));
  }
  /// The moduli of the next snapshot, which the bases of loads_done() loads have already.
  [[nodiscard]] const std::vector<Moduli>& next_moduli() const {
    return bases_.front().response().snapshots.back().moduli;
  }
  /// The effort up to the last solution that is part of a basis.
  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }

  /// The moduli of the training set with the largest error estimate of all loads. Estimates are scaled by the ratios of
  /// error to residual measured so far. An estimate that rounding alone may have caused, or with a residual as small as
  /// that of a snapshot itself, counts as no error, since no further snapshot would reduce it.
  [[nodiscard]] Candidate greedy_choice(std::span<const std::vector<Moduli>> training_set) const {
    Candidate choice, within_rounding;
    for (std::size_t l = 0; l < bases_.size(); ++l) add_candidates(l, training_set, choice, within_rounding);
    return choice.estimate > 0.0 ? choice : Candidate{within_rounding.moduli, 0.0};
  }

  /// The largest error estimate of one load in the training set, computed as in greedy_choice().
  [[nodiscard]] double largest_estimate(std::size_t load, std::span<const std::vector<Moduli>> training_set) const {
    Candidate choice, within_rounding;
    add_candidates(load, training_set, choice, within_rounding);
    return std::max(0.0, choice.estimate);
  }

  /// Takes over what a solver has counted, before its first solution too, so that a state that is saved has it.
  void take_effort(const LinearEffort& effort) { effort_ = effort; }

  [[nodiscard]] bool is_snapshot(const std::vector<Moduli>& moduli) const {
    return std::ranges::any_of(bases_.front().response().snapshots,
                               [&](const Snapshot& one) { return are_equal(one.moduli, moduli); });
  }

  [[nodiscard]] std::vector<ReducedResponse> responses() const {
    std::vector<ReducedResponse> responses;
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      auto& response = responses.emplace_back(bases_[l].response());
      response.residual_scale = scales_[l];
      for (std::size_t i = 0; i < measured_[l].size(); ++i) response.snapshots[i].error_before = measured_[l][i];
    }
    return responses;
  }

  void save(StateWriter& state) const {
    state.write("/sampling/snapshots", std::int64_t{snapshots_});
    state.write("/sampling/error", error_);
    state.write("/sampling/scales", scales_);
    breccia::save(state, "/effort", effort_);
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      const auto group = fmt::format("/sampling/load/{}", l);
      state.write(group + "/measured", measured_[l]);
      bases_[l].save(state, group);
    }
  }

  void restore(const StateReader& state) {
    snapshots_ = static_cast<int>(state.integer("/sampling/snapshots"));
    error_ = state.number("/sampling/error");
    scales_ = state.numbers("/sampling/scales", bases_.size());
    effort_ = read_effort(state, "/effort");
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      const auto group = fmt::format("/sampling/load/{}", l);
      measured_[l] = state.numbers(group + "/measured");
      bases_[l].restore(state, group);
    }
  }

 private:
  /// Replaces the candidates of other loads by those of this load that have a larger estimate: one candidate among
  /// estimates that rounding alone may have caused, and one among all other estimates.
  void add_candidates(std::size_t load, std::span<const std::vector<Moduli>> training_set, Candidate& choice,
                      Candidate& within_rounding) const {
    auto response = bases_[load].response();
    response.residual_scale = scales_[load] > 0.0 ? scales_[load] : 1.0;
    for (const auto& moduli : training_set) {
      const double estimate = response.error_estimate(moduli);
      const bool is_rounding =
          estimate <= rounding_of_error_estimate(response, moduli) || has_residual_of_snapshot(response, moduli);
      auto& largest = is_rounding ? within_rounding : choice;
      if (estimate > largest.estimate) largest = {moduli, estimate};
    }
  }

  [[nodiscard]] std::vector<double> parameters(std::span<const Moduli> varying) const {
    return bases_.front().response().parameters(varying);
  }

  /// Solves for each load that is not done, and adds the solution after error_at(load, solution) has returned the error
  /// to record. An exception of the solver leaves the bases as they are after the last solution.
  template <class Solver, class ErrorAt>
  void add_snapshot(Solver& solver, const std::vector<Moduli>& at, const ErrorAt& error_at) {
    const auto first = loads_done();
    effort_ = solver.effort();
    solver.prepare(parameters(at));
    // The run that was ended has counted the preparation for these moduli.
    if (first > 0) solver.count_from(effort_);
    for (std::size_t l = first; l < bases_.size(); ++l) {
      auto solution = solver.solve(bases_[l].load(), bases_[l].approximation(at));
      const double error = error_at(l, solution);
      bases_[l].add(std::move(solution), at);
      measured_[l].push_back(error);
      effort_ = solver.effort();
    }
    ++snapshots_;
  }

  /// Modulus [Pa] of the composite, from the energy of a solution.
  [[nodiscard]] double modulus_of(std::size_t load, std::span<const Moduli> at, const Vector& solution) const {
    const auto forces = composite_->forces(parameters(at), bases_[load].load(), solution);
    const double energy = work(forces, solution) / composite_->volume();
    return composite_->boundary() == Boundary::traction ? 1.0 / energy : energy;
  }

  /// Relative error of the reduced response to a load at these moduli. Updates the ratio of error to residual, unless
  /// the error is so far below the tolerance that it may come from the linear solver.
  double measure_error(std::size_t load, const Vector& solution, std::span<const Moduli> at, double tolerance) {
    constexpr double least_share = 0.1;
    auto response = bases_[load].response();
    response.residual_scale = 1.0;
    const double exact = modulus_of(load, at, solution);
    const double error = std::abs(response.modulus(at) / exact - 1.0);
    if (error > least_share * tolerance || scales_[load] == 0.0) {
      // An estimate below its rounding error is meaningless, and may be zero.
      const double estimate = std::max(response.error_estimate(at), rounding_of_error_estimate(response, at));
      scales_[load] = std::max(scales_[load], error / estimate);
    }
    return error;
  }

  const Composite* composite_;
  std::vector<ReducedBasis<Composite>> bases_;  ///< bases by load
  std::vector<double> scales_;                  ///< largest ratio of error to residual found so far, by load
  std::vector<std::vector<double>> measured_;   ///< errors of the snapshots, by load
  LinearEffort effort_;
  int snapshots_ = 0;
  double error_ = 1.0;
};

/// The middle of a training set, and both of its ends where they differ from the middle.
[[nodiscard]] std::vector<std::vector<Moduli>> initial_snapshots(const TrainingPath& training_set);

/// Throws InputError when there are no loads, the training set is empty, or a point of it does not have the moduli of
/// each of its phases.
void require_complete(std::span<const Load> loads, const TrainingPath& training_set);

/// Throws NumericalError for an error, where no more snapshots are allowed, that leaves no useful modulus.
void require_useful(double error, const TrainingPath& training_set, const SamplingOptions& options);

/// Whether bases that meet the tolerance at Laplace variables have changed the target little by their last vectors, or
/// would not gain from further ones, because the remaining error of a load at Laplace variables is far below the
/// tolerance, or as small as the error of the linear solver.
template <AffineComposite Composite>
[[nodiscard]] bool is_accurate_in_time(const GreedySampling<Composite>& sampling, const TrainingPath& training_set,
                                       const Candidate& next, double tolerance) {
  if (!training_set.target || sampling.is_snapshot(next.moduli)) return true;
  // The remaining error may be as large as the last change.
  constexpr double change_by_last = 10.0, far_below = 1e-3, of_the_solver = 1e-8;
  const double nothing = std::max(far_below * tolerance, of_the_solver);
  for (std::size_t load = 0; load < sampling.bases().size(); ++load) {
    if (sampling.largest_estimate(load, training_set.points) <= nothing) continue;
    const auto response = sampling.bases()[load].response();
    if (!(change_by_last_vector(response, *training_set.target) <= change_by_last * tolerance)) return false;
  }
  return true;
}

/// Adds snapshots of the training set until the tolerance is met, and then, where the set has a target, until it is
/// accurate in time, as long as more snapshots are allowed. Where rounding keeps the tolerance from being met, the
/// bases are as accurate as they can be, and their estimates tell how accurate. With a checkpoint, the state is saved
/// between snapshots when that is due, and within a solution, as it was before it, when the run shall end.
template <AffineComposite Composite, CompositeSolver<typename Composite::Vector> Solver>
void sample(GreedySampling<Composite>& sampling, Solver& solver, const TrainingPath& training_set,
            const SamplingOptions& options, const ProgressObserver& observer, Checkpoint* checkpoint) {
  SamplingProgress progress(options, sampling.bases().size());
  sampling.take_effort(solver.effort());
  const auto save = [&] { checkpoint->save([&](StateWriter& state) { sampling.save(state); }); };
  const auto save_if_due = [&] {
    if (checkpoint != nullptr && checkpoint->is_due()) save();
  };
  const auto report = [&] {
    if (observer) observer(progress.after(sampling.snapshots(), sampling.error()));
  };
  if constexpr (requires { solver.watch(std::function<void()>()); }) {
    solver.watch([&] {
      if (checkpoint != nullptr && checkpoint->is_to_end()) save();
      if (observer) observer(progress.within_solution(sampling.snapshots(), sampling.loads_done()));
    });
  }
  const auto initial = initial_snapshots(training_set);
  for (auto i = static_cast<std::size_t>(sampling.snapshots()); i < initial.size(); ++i) {
    save_if_due();
    sampling.add_initial_snapshot(solver, initial[i]);
    report();
    for (const auto& basis : sampling.bases()) {
      if (basis.response().load_forces.size() > 0) continue;
      throw NumericalError("reduced basis: the first solution vanishes; a modulus may be beyond what numbers can hold");
    }
  }
  if (sampling.loads_done() > 0) {
    const auto moduli = sampling.next_moduli();
    sampling.add_selected_snapshot(solver, moduli, options.tolerance);
    report();
  }
  while (training_set.points.size() > 1) {
    const auto choice = sampling.greedy_choice(training_set.points);
    const double error = std::max(sampling.error(), choice.estimate);
    if (error <= options.tolerance && is_accurate_in_time(sampling, training_set, choice, options.tolerance)) break;
    if (sampling.snapshots() >= options.most_snapshots) {
      require_useful(error, training_set, options);
      break;
    }
    save_if_due();
    sampling.add_selected_snapshot(solver, choice.moduli, options.tolerance);
    report();
  }
}

}  // namespace breccia::quasistatic
