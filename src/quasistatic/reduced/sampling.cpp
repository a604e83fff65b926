#include "breccia/quasistatic/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/error.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/quasistatic/linear_effort_state.hpp"

#include "operator/displacement_state.hpp"
#include "operator/recovery.hpp"
#include "reduced/network.hpp"
#include "reduced/reduced_basis.hpp"
#include "reduced/residual_rounding.hpp"
#include "solvers/elastic_solver.hpp"

namespace breccia {
namespace {

using quasistatic::AffineStiffness;
using quasistatic::Displacement;
using quasistatic::ElasticOperator;
using quasistatic::ElasticSolver;
using quasistatic::ReducedBasis;

/// The solution for moduli [Pa] by material. The reduced solution is the initial guess; it is that for these moduli of
/// the phases that vary.
Displacement solve(const ElasticOperator<2>& elastic_operator, ElasticSolver& solver, const ReducedBasis& basis,
                   const std::vector<Moduli>& moduli, std::span<const Moduli> varying) {
  auto solution = basis.approximation(varying);
  auto forces = elastic_operator.zero();
  double macroscopic = 0.0;
  if (elastic_operator.boundary() == Boundary::traction) {
    forces = elastic_operator.load_forces(basis.load());
  } else {
    macroscopic = 1.0;
    auto prescribed = elastic_operator.zero();
    prescribed.set_macroscopic(macroscopic);
    forces.add(-1.0, elastic_operator.forces(moduli, basis.load(), prescribed));
  }
  solver.solve(forces, solution);
  solution.set_macroscopic(macroscopic);
  return solution;
}

/// Modulus [Pa] of the composite, from the energy of a solution.
double modulus_of(const ElasticOperator<2>& elastic_operator, const ReducedBasis& basis,
                  const std::vector<Moduli>& moduli, const Displacement& solution) {
  const double energy =
      work(elastic_operator.forces(moduli, basis.load(), solution), solution) / elastic_operator.volume();
  return elastic_operator.boundary() == Boundary::traction ? 1.0 / energy : energy;
}

/// The candidate for the next snapshot: where in the training set the error estimate is largest.
struct Candidate {
  std::vector<Moduli> moduli;  ///< [Pa] of the phases that vary
  double estimate = -1.0;
};

/// The reduced basis of each load, which grows snapshot by snapshot by a greedy selection. The bases point to the
/// operator and to the affine stiffness.
class GreedySampling {
 public:
  GreedySampling(const QuasistaticProblem& problem, std::span<const VaryingPhase> varying, std::span<const Load> loads,
                 const std::vector<Moduli>& reference)
      : stiffness_(quasistatic::affine_stiffness(problem.materials, varying)),
        elastic_operator_(problem.discretisation, problem.volumetric, problem.boundary),
        scales_(loads.size(), 0.0),
        measured_(loads.size()) {
    for (const auto load : loads) bases_.emplace_back(elastic_operator_, stiffness_, load, reference);
  }

  [[nodiscard]] const AffineStiffness& stiffness() const noexcept { return stiffness_; }
  [[nodiscard]] const ElasticOperator<2>& elastic_operator() const noexcept { return elastic_operator_; }
  [[nodiscard]] const std::vector<ReducedBasis>& bases() const noexcept { return bases_; }
  [[nodiscard]] int snapshots() const noexcept { return snapshots_; }
  /// Relative error at the last snapshot before it was added; 1 when it was not measured.
  [[nodiscard]] double error() const noexcept { return error_; }

  /// Adds the snapshot at these moduli to the basis of each load, without measuring the error there.
  void add_initial_snapshot(ElasticSolver& solver, const std::vector<Moduli>& at) {
    add_snapshot(solver, at, [](std::size_t, const Displacement&) { return 0.0; });
    error_ = 1.0;
  }

  /// Measures the error of each reduced response at these moduli, and adds the snapshot.
  void add_selected_snapshot(ElasticSolver& solver, const std::vector<Moduli>& at, double tolerance) {
    error_ = 0.0;
    add_snapshot(solver, at, [&](std::size_t load, const Displacement& solution) {
      const double error = measure_error(load, solution, at, tolerance);
      error_ = std::max(error_, error);
      return error;
    });
  }

  /// The moduli of the training set with the largest error estimate of all loads. Estimates are scaled by the ratios of
  /// error to residual measured so far. One that rounding alone may have caused counts as no error, since no further
  /// snapshot would reduce it.
  [[nodiscard]] Candidate greedy_choice(std::span<const std::vector<Moduli>> training_set) const {
    Candidate choice, within_rounding;
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      auto response = bases_[l].response();
      response.residual_scale = scales_[l] > 0.0 ? scales_[l] : 1.0;
      for (const auto& moduli : training_set) {
        const double estimate = response.error_estimate(moduli);
        const bool is_rounding = estimate <= quasistatic::rounding_of_error_estimate(response, moduli);
        auto& largest = is_rounding ? within_rounding : choice;
        if (estimate > largest.estimate) largest = {moduli, estimate};
      }
    }
    return choice.estimate > 0.0 ? choice : Candidate{within_rounding.moduli, 0.0};
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
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      const auto group = fmt::format("/sampling/load/{}", l);
      measured_[l] = state.numbers(group + "/measured");
      bases_[l].restore(state, group);
    }
  }

 private:
  /// Moduli by material [Pa] of the composite with these moduli of the phases that vary.
  [[nodiscard]] std::vector<Moduli> moduli_at(std::span<const Moduli> varying) const {
    return stiffness_.moduli_at(bases_.front().response().parameters(varying));
  }

  /// Solves for each load, and adds the solution after error_at(load, solution) has returned the error to record.
  template <class ErrorAt>
  void add_snapshot(ElasticSolver& solver, const std::vector<Moduli>& at, const ErrorAt& error_at) {
    const auto moduli = moduli_at(at);
    solver.set_moduli(moduli);
    solver.update_preconditioner();
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      auto solution = solve(elastic_operator_, solver, bases_[l], moduli, at);
      measured_[l].push_back(error_at(l, solution));
      bases_[l].add(std::move(solution), at);
    }
    ++snapshots_;
  }

  /// Relative error of the reduced response to a load at these moduli. Updates the ratio of error to residual, unless
  /// the error is so far below the tolerance that it may come from the linear solver.
  double measure_error(std::size_t load, const Displacement& solution, std::span<const Moduli> at, double tolerance) {
    constexpr double least_share = 0.1;
    auto response = bases_[load].response();
    response.residual_scale = 1.0;
    const double exact = modulus_of(elastic_operator_, bases_[load], moduli_at(at), solution);
    const double error = std::abs(response.modulus(at) / exact - 1.0);
    if (error > least_share * tolerance || scales_[load] == 0.0) {
      // An estimate below its rounding may be anything, and zero.
      const double estimate =
          std::max(response.error_estimate(at), quasistatic::rounding_of_error_estimate(response, at));
      scales_[load] = std::max(scales_[load], error / estimate);
    }
    return error;
  }

  AffineStiffness stiffness_;
  ElasticOperator<2> elastic_operator_;
  std::vector<ReducedBasis> bases_;            ///< by load
  std::vector<double> scales_;                 ///< largest ratio of error to residual found so far, by load
  std::vector<std::vector<double>> measured_;  ///< errors of the snapshots, by load
  int snapshots_ = 0;
  double error_ = 1.0;
};

PointFields<2> recover(const GreedySampling& sampling, const QuasistaticProblem& problem, std::size_t load,
                       std::span<const Material> of_phases, double time) {
  const auto& basis = sampling.bases().at(load);
  const auto& stiffness = sampling.stiffness();
  const auto state = quasistatic::network_state(basis.response(), of_phases, time);
  // The load forces e of the basis are those of the unit load over the square root of the area.
  const double unit = std::sqrt(sampling.elastic_operator().volume());
  const auto combined = [&](const Eigen::VectorXd& weights) { return basis.combination(unit * weights); };
  const auto displacement = combined(state.displacement);
  std::vector<quasistatic::AppliedModuli> applied;
  for (const auto& [bulk, shear] : stiffness.constant) {
    applied.push_back({displacement.copy(), displacement.copy()});
    applied.back().bulk.scale(bulk);
    applied.back().shear.scale(shear);
  }
  for (std::size_t i = 0; i < stiffness.parts.size(); ++i) {
    const auto& part = stiffness.parts[i];
    auto& [bulk, shear] = applied[part.phase];
    (part.parameter.modulus == ElasticModulus::shear ? shear : bulk) = combined(state.applied[i]);
  }
  return quasistatic::recover_fields(sampling.elastic_operator(), problem.discretisation, problem.volumetric,
                                     basis.load(), displacement, applied);
}

bool are_equal(std::span<const Moduli> some, std::span<const Moduli> others) {
  return std::ranges::equal(some, others, [](const Moduli& one, const Moduli& other) {
    return one.bulk == other.bulk && one.shear == other.shear;
  });
}

/// The middle of the training set, and both its ends where they differ from it.
std::vector<std::vector<Moduli>> initial_snapshots(std::span<const std::vector<Moduli>> training_set) {
  std::vector<std::vector<Moduli>> initial = {training_set[training_set.size() / 2]};
  for (const auto& end : {training_set.front(), training_set.back()}) {
    if (!are_equal(end, initial.front())) initial.push_back(end);
  }
  return initial;
}

void require_complete(const QuasistaticProblem& problem, std::span<const Load> loads,
                      const TrainingPath& training_set) {
  if (training_set.points.empty()) throw InputError("reduced basis: no moduli to sample");
  const auto phases = training_set.phases.size();
  for (const auto& point : training_set.points) {
    if (point.size() == phases) continue;
    throw InputError(
        fmt::format("reduced basis: expected the moduli of {} phases at each point of the training set, "
                    "got those of {}",
                    phases, point.size()));
  }
  if (loads.empty()) throw InputError("reduced basis: no loads");
  require_phases_in_cells("reduced basis", problem.discretisation, problem.materials.size());
}

void require_first_vectors(const GreedySampling& sampling) {
  for (const auto& basis : sampling.bases()) {
    if (basis.response().load_forces.size() > 0) continue;
    throw NumericalError("reduced basis: the first solution vanishes; a modulus may be beyond what numbers can hold");
  }
}

/// Throws NumericalError when as many snapshots as allowed have not met the tolerance.
void require_more_snapshots(const GreedySampling& sampling, double error, const SamplingOptions& options) {
  if (sampling.snapshots() < options.most_snapshots) return;
  throw NumericalError(
      fmt::format("reduced basis: the error is still {:.1e} after {} snapshots, wanted {:.1e}; a coarser "
                  "tests.quasistatic.tolerance, tests.quasistatic.range = \"times\" or tests.solver = \"stepping\" "
                  "may serve",
                  error, options.most_snapshots, options.tolerance));
}

}  // namespace

SampledResponses sample_responses(const QuasistaticProblem& problem, std::span<const Load> loads,
                                  const TrainingPath& training_set, const SamplingOptions& options,
                                  const std::function<void(const SamplingProgress&)>& observer,
                                  Checkpoint* checkpoint) {
  require_complete(problem, loads, training_set);
  const auto initial = initial_snapshots(training_set.points);
  const auto sampling = std::make_shared<GreedySampling>(problem, training_set.phases, loads, initial.front());
  const auto solver = quasistatic::make_elastic_solver(sampling->elastic_operator(), problem.linear);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    quasistatic::require_as_many_processes(*earlier);
    sampling->restore(*earlier);
    solver->count_from(read_effort(*earlier, "/effort"));
  }
  const auto save_if_due = [&] {
    if (checkpoint == nullptr || !checkpoint->is_due()) return;
    checkpoint->save([&](StateWriter& state) {
      state.write("/processes", std::int64_t{parallel::ranks()});
      save(state, "/effort", solver->effort());
      sampling->save(state);
    });
  };
  const auto report = [&] {
    if (observer) observer({sampling->snapshots(), sampling->error()});
  };

  for (auto i = static_cast<std::size_t>(sampling->snapshots()); i < initial.size(); ++i) {
    save_if_due();
    sampling->add_initial_snapshot(*solver, initial[i]);
    report();
    require_first_vectors(*sampling);
  }
  while (training_set.points.size() > 1) {
    const auto choice = sampling->greedy_choice(training_set.points);
    const double error = std::max(sampling->error(), choice.estimate);
    if (error <= options.tolerance) break;
    require_more_snapshots(*sampling, error, options);
    save_if_due();
    sampling->add_selected_snapshot(*solver, choice.moduli, options.tolerance);
    report();
  }

  return {.responses = sampling->responses(),
          .effort = solver->effort(),
          .fields = [sampling, problem](std::size_t load, std::span<const Material> of_phases, double time) {
            return recover(*sampling, problem, load, of_phases, time);
          }};
}

}  // namespace breccia
