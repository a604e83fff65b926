#include "breccia/quasistatic/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "elastic_solver.hpp"
#include "network.hpp"
#include "recovery.hpp"
#include "reduced_basis.hpp"

namespace breccia {
namespace {

using quasistatic::ElasticBox;
using quasistatic::ElasticSolver;
using quasistatic::Field;
using quasistatic::ReducedBasis;
using quasistatic::StiffnessParts;

StiffnessParts parts_of(const QuasistaticProblem& problem, MaterialIndex matrix) {
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

/// Over all loads, with the ratios of error to residual found so far.
Worst worst_on(std::span<const Moduli> path, const std::vector<ReducedBasis>& bases,
               const std::vector<double>& scales) {
  Worst worst;
  for (std::size_t l = 0; l < bases.size(); ++l) {
    auto response = bases[l].response();
    response.residual_scale = scales[l] > 0.0 ? scales[l] : 1.0;
    for (const auto& moduli : path) {
      const double estimate = response.error_estimate(moduli);
      if (estimate > worst.estimate) worst = {moduli, estimate};
    }
  }
  return worst;
}

/// What the recovery of fields needs. The bases point to the box and the parts.
struct Sampling {
  Sampling(const QuasistaticProblem& problem, MaterialIndex matrix)
      : parts(parts_of(problem, matrix)), box(problem.discretisation, problem.volumetric, problem.boundary) {}

  StiffnessParts parts;
  ElasticBox box;
  std::vector<ReducedBasis> bases;  ///< by load
};

PointFields recover(const Sampling& sampling, const QuasistaticProblem& problem, MaterialIndex matrix_index,
                    std::size_t load, const Material& matrix, double time) {
  const auto& basis = sampling.bases.at(load);
  const auto state = quasistatic::network_state(basis.response(), matrix, time);
  // A unit of e is that of the load over the root of the area.
  const double unit = std::sqrt(sampling.box.area());
  const auto combined = [&](const Eigen::VectorXd& weights) { return basis.combination(unit * weights); };
  const auto displacement = combined(state.displacement);
  std::vector<quasistatic::AppliedModuli> applied;
  for (std::size_t m = 0; m < sampling.parts.filler.size(); ++m) {
    if (m == matrix_index) {
      applied.push_back({combined(state.bulk), combined(state.shear)});
    } else {
      applied.push_back({displacement.copy(), displacement.copy()});
      applied.back().bulk.scale(sampling.parts.filler[m].bulk);
      applied.back().shear.scale(sampling.parts.filler[m].shear);
    }
  }
  return quasistatic::recover_fields(sampling.box, problem.discretisation, problem.volumetric, basis.load(),
                                     displacement, applied);
}

}  // namespace

SampledResponses sample_responses(const QuasistaticProblem& problem, MaterialIndex matrix, std::span<const Load> loads,
                                  std::span<const Moduli> path, const SamplingOptions& options,
                                  const std::function<void(const SamplingProgress&)>& observer) {
  if (path.empty()) throw InputError("reduced basis: no moduli of the matrix to sample");
  const auto sampling = std::make_shared<Sampling>(problem, matrix);
  const auto& parts = sampling->parts;
  const auto& box = sampling->box;
  auto& bases = sampling->bases;
  const auto solver = quasistatic::make_elastic_solver(box, problem.linear);
  const auto& middle = path[path.size() / 2];
  for (const auto load : loads) bases.emplace_back(box, parts, load, middle);

  std::vector<double> scales(loads.size(), 0.0);
  std::vector<std::vector<double>> measured(loads.size());
  double error = 1.0;
  int snapshots = 0;
  const auto add_snapshot = [&](const Moduli& at, bool is_measured) {
    const auto moduli = parts.with(at);
    solver->set_moduli(moduli);
    solver->refresh();
    error = is_measured ? 0.0 : 1.0;
    for (std::size_t l = 0; l < bases.size(); ++l) {
      auto solution = solve(box, *solver, bases[l], moduli, at);
      double relative = 0.0;
      if (is_measured) {
        auto response = bases[l].response();
        response.residual_scale = 1.0;
        relative = std::abs(response.modulus(at) / modulus_of(box, bases[l], moduli, solution) - 1.0);
        // Far below the tolerance an error tells of the linear solver, not of the basis.
        constexpr double telling = 0.1;
        if (relative > telling * options.tolerance || scales[l] == 0.0) {
          scales[l] = std::max(scales[l], relative / std::max(response.error_estimate(at), 1e-300));
        }
        error = std::max(error, relative);
      }
      measured[l].push_back(relative);
      bases[l].add(std::move(solution), at);
    }
    ++snapshots;
    if (observer) observer({snapshots, error});
  };

  add_snapshot(middle, false);
  for (const auto& basis : bases) {
    if (basis.response().load_forces.size() > 0) continue;
    throw NumericalError("reduced basis: the first solution vanishes; a modulus may be beyond what numbers can hold");
  }
  for (const auto& end : {path.front(), path.back()}) {
    if (end.bulk != middle.bulk || end.shear != middle.shear) add_snapshot(end, false);
  }
  auto worst = worst_on(path, bases, scales);
  while (path.size() > 1 && std::max(error, worst.estimate) > options.tolerance) {
    if (snapshots == options.most_snapshots) {
      throw NumericalError(
          fmt::format("reduced basis: the error is still {:.1e} after {} snapshots, wanted {:.1e}; a coarser tolerance "
                      "or solver = \"stepping\" may serve",
                      std::max(error, worst.estimate), options.most_snapshots, options.tolerance));
    }
    add_snapshot(worst.moduli, true);
    worst = worst_on(path, bases, scales);
  }

  SampledResponses sampled;
  sampled.effort = solver->effort();
  for (std::size_t l = 0; l < bases.size(); ++l) {
    auto response = bases[l].response();
    response.residual_scale = scales[l];
    for (std::size_t i = 0; i < measured[l].size(); ++i) response.snapshots[i].error_before = measured[l][i];
    sampled.responses.push_back(std::move(response));
  }
  sampled.fields = [sampling, problem, matrix](std::size_t load, const Material& material, double time) {
    return recover(*sampling, problem, matrix, load, material, time);
  };
  return sampled;
}

}  // namespace breccia
