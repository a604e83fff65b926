#include "breccia/quasistatic/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/parallel/session.hpp"

#include "elastic_solver.hpp"
#include "network.hpp"
#include "recovery.hpp"
#include "reduced_basis.hpp"
#include "residual_rounding.hpp"

namespace breccia {
namespace {

using quasistatic::ElasticBox;
using quasistatic::ElasticSolver;
using quasistatic::Field;
using quasistatic::ReducedBasis;
using quasistatic::StiffnessParts;

StiffnessParts parts_of(const QuasistaticProblem& problem, PhaseIndex matrix) {
  const auto count = problem.materials.size();
  StiffnessParts parts = {std::vector<Moduli>(count, {0.0, 0.0}), std::vector<Moduli>(count, {0.0, 0.0}),
                          std::vector<Moduli>(count, {0.0, 0.0})};
  for (std::size_t m = 0; m < count; ++m) {
    const auto& [name, density, bulk, shear] = problem.materials[m];
    if (m == matrix) continue;
    if (!bulk.is_elastic() || !shear.is_elastic()) {
      throw InputError(
          fmt::format("reduced basis: {} relaxes; with a filler that relaxes, take solver = \"stepping\"", name));
    }
    parts.filler[m] = {bulk.equilibrium(), shear.equilibrium()};
  }
  parts.matrix_shear.at(matrix).shear = 1.0;
  parts.matrix_bulk.at(matrix).bulk = 1.0;
  return parts;
}

/// The solution for an elastic matrix, from the best guess that the basis has.
Field solve(const ElasticBox& box, ElasticSolver& solver, const ReducedBasis& basis, const std::vector<Moduli>& moduli,
            const Moduli& matrix) {
  auto solution = basis.approximation(matrix);
  auto forces = box.zero_field();
  double affine = 0.0;
  if (box.boundary() == Boundary::traction) {
    forces = box.load_forces(basis.load());
  } else {
    affine = 1.0;
    auto given = box.zero_field();
    given.set_affine(affine);
    forces.add(-1.0, box.forces(moduli, basis.load(), given));
  }
  solver.solve(forces, solution);
  solution.set_affine(affine);
  return solution;
}

/// Modulus [Pa] that a solution tells.
double modulus_of(const ElasticBox& box, const ReducedBasis& basis, const std::vector<Moduli>& moduli,
                  const Field& solution) {
  const double energy = work(box.forces(moduli, basis.load(), solution), solution) / box.area();
  return box.boundary() == Boundary::traction ? 1.0 / energy : energy;
}

/// Where on the path an error is expected to be largest.
struct Worst {
  Moduli moduli{};
  double estimate = -1.0;
};

/// The basis of each load, as it grows solution by solution. The bases point to the box and the parts.
class Sampling {
 public:
  Sampling(const QuasistaticProblem& problem, PhaseIndex matrix, std::span<const Load> loads, const Moduli& reference)
      : parts_(parts_of(problem, matrix)),
        box_(problem.discretisation, problem.volumetric, problem.boundary),
        scales_(loads.size(), 0.0),
        measured_(loads.size()) {
    for (const auto load : loads) bases_.emplace_back(box_, parts_, load, reference);
  }

  [[nodiscard]] const StiffnessParts& parts() const noexcept { return parts_; }
  [[nodiscard]] const ElasticBox& box() const noexcept { return box_; }
  [[nodiscard]] const std::vector<ReducedBasis>& bases() const noexcept { return bases_; }
  [[nodiscard]] int snapshots() const noexcept { return snapshots_; }
  /// Relative, at the last snapshot before it was added; 1 where it was not measured.
  [[nodiscard]] double error() const noexcept { return error_; }

  /// Adds a snapshot of each load. One that is measured tells how good the bases were there before; far below the
  /// tolerance that tells of the linear solver.
  void add_snapshot(ElasticSolver& solver, const Moduli& at, bool is_measured, double tolerance) {
    const auto moduli = parts_.with(at);
    solver.set_moduli(moduli);
    solver.refresh();
    error_ = is_measured ? 0.0 : 1.0;
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      auto solution = solve(box_, solver, bases_[l], moduli, at);
      double relative = 0.0;
      if (is_measured) {
        auto response = bases_[l].response();
        response.residual_scale = 1.0;
        relative = std::abs(response.modulus(at) / modulus_of(box_, bases_[l], moduli, solution) - 1.0);
        constexpr double telling = 0.1;
        if (relative > telling * tolerance || scales_[l] == 0.0) {
          scales_[l] = std::max(scales_[l], relative / std::max(response.error_estimate(at), 1e-300));
        }
        error_ = std::max(error_, relative);
      }
      measured_[l].push_back(relative);
      bases_[l].add(std::move(solution), at);
    }
    ++snapshots_;
  }

  /// Over all loads, with the ratios of error to residual found so far. Where rounding may have made all of an estimate
  /// no error is expected, for no solution would make it smaller.
  [[nodiscard]] Worst worst_on(std::span<const Moduli> path) const {
    Worst worst, within_rounding;
    for (std::size_t l = 0; l < bases_.size(); ++l) {
      auto response = bases_[l].response();
      response.residual_scale = scales_[l] > 0.0 ? scales_[l] : 1.0;
      for (const auto& moduli : path) {
        const double estimate = response.error_estimate(moduli);
        const bool is_rounding = estimate <= quasistatic::rounding_of_error_estimate(response, moduli);
        auto& largest = is_rounding ? within_rounding : worst;
        if (estimate > largest.estimate) largest = {moduli, estimate};
      }
    }
    return worst.estimate > 0.0 ? worst : Worst{within_rounding.moduli, 0.0};
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
  StiffnessParts parts_;
  ElasticBox box_;
  std::vector<ReducedBasis> bases_;            ///< by load
  std::vector<double> scales_;                 ///< largest ratio of error to residual found so far, by load
  std::vector<std::vector<double>> measured_;  ///< errors of the snapshots, by load
  int snapshots_ = 0;
  double error_ = 1.0;
};

PointFields<2> recover(const Sampling& sampling, const QuasistaticProblem& problem, PhaseIndex matrix_index,
                       std::size_t load, const Material& matrix, double time) {
  const auto& basis = sampling.bases().at(load);
  const auto state = quasistatic::network_state(basis.response(), matrix, time);
  // A unit of e is that of the load over the root of the area.
  const double unit = std::sqrt(sampling.box().area());
  const auto combined = [&](const Eigen::VectorXd& weights) { return basis.combination(unit * weights); };
  const auto displacement = combined(state.displacement);
  std::vector<quasistatic::AppliedModuli> applied;
  for (std::size_t m = 0; m < sampling.parts().filler.size(); ++m) {
    if (m == matrix_index) {
      applied.push_back({combined(state.bulk), combined(state.shear)});
    } else {
      applied.push_back({displacement.copy(), displacement.copy()});
      applied.back().bulk.scale(sampling.parts().filler[m].bulk);
      applied.back().shear.scale(sampling.parts().filler[m].shear);
    }
  }
  return quasistatic::recover_fields(sampling.box(), problem.discretisation, problem.volumetric, basis.load(),
                                     displacement, applied);
}

/// Both ends of the path and its middle, the middle first.
std::vector<Moduli> first_moduli(std::span<const Moduli> path) {
  std::vector<Moduli> first = {path[path.size() / 2]};
  for (const auto& end : {path.front(), path.back()}) {
    if (end.bulk != first.front().bulk || end.shear != first.front().shear) first.push_back(end);
  }
  return first;
}

}  // namespace

SampledResponses sample_responses(const QuasistaticProblem& problem, PhaseIndex matrix, std::span<const Load> loads,
                                  std::span<const Moduli> path, const SamplingOptions& options,
                                  const std::function<void(const SamplingProgress&)>& observer,
                                  Checkpoint* checkpoint) {
  if (path.empty()) throw InputError("reduced basis: no moduli of the matrix to sample");
  const auto first = first_moduli(path);
  const auto sampling = std::make_shared<Sampling>(problem, matrix, loads, first.front());
  const auto solver = quasistatic::make_elastic_solver(sampling->box(), problem.linear);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    quasistatic::require_as_many_processes(*earlier);
    sampling->restore(*earlier);
    solver->count_from(read_effort(*earlier, "/effort"));
  }
  const auto add_snapshot = [&](const Moduli& at, bool is_measured) {
    if (checkpoint != nullptr && checkpoint->is_due()) {
      checkpoint->save([&](StateWriter& state) {
        state.write("/processes", std::int64_t{parallel::ranks()});
        save(state, "/effort", solver->effort());
        sampling->save(state);
      });
    }
    sampling->add_snapshot(*solver, at, is_measured, options.tolerance);
    if (observer) observer({sampling->snapshots(), sampling->error()});
  };

  for (auto i = static_cast<std::size_t>(sampling->snapshots()); i < first.size(); ++i) {
    add_snapshot(first[i], false);
    for (const auto& basis : sampling->bases()) {
      if (basis.response().load_forces.size() > 0) continue;
      throw NumericalError("reduced basis: the first solution vanishes; a modulus may be beyond what numbers can hold");
    }
  }
  auto worst = sampling->worst_on(path);
  while (path.size() > 1 && std::max(sampling->error(), worst.estimate) > options.tolerance) {
    if (sampling->snapshots() == options.most_snapshots) {
      throw NumericalError(
          fmt::format("reduced basis: the error is still {:.1e} after {} snapshots, wanted {:.1e}; a coarser "
                      "tests.quasistatic.tolerance, tests.quasistatic.range = \"times\" or tests.solver = \"stepping\" "
                      "may serve",
                      std::max(sampling->error(), worst.estimate), options.most_snapshots, options.tolerance));
    }
    add_snapshot(worst.moduli, true);
    worst = sampling->worst_on(path);
  }

  return {.responses = sampling->responses(),
          .effort = solver->effort(),
          .fields = [sampling, problem, matrix](std::size_t load, const Material& material, double time) {
            return recover(*sampling, problem, matrix, load, material, time);
          }};
}

}  // namespace breccia
