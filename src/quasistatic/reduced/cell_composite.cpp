#include "quasistatic/reduced/cell_composite.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/contrast.hpp"
#include "parallel/reduction.hpp"
#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/operator/recovery.hpp"
#include "quasistatic/operator/square_forces.hpp"

namespace breccia::quasistatic {

template <int dim>
CellComposite<dim>::CellComposite(const QuasistaticProblem<dim>& problem, std::span<const VaryingPhase> varying)
    : stiffness_(affine_stiffness(problem.materials, varying)),
      elastic_operator_(problem.discretisation, problem.volumetric, problem.boundary, problem.linear.threads,
                        problem.crystals, problem.materials) {
  for (const auto& [phase, crystal] : problem.crystals) {
    if (phase >= stiffness_.constant.size() ||
        std::ranges::find(varying, phase, &VaryingPhase::index) != varying.end()) {
      throw InputError(fmt::format("crystals: phase {} has no material, or its moduli vary", phase));
    }
    stiffness_.constant[phase] = softer_moduli<dim>(stiffness_in<dim>(crystal.stiffness));
  }
}

template <int dim>
std::vector<PhaseModulus> CellComposite<dim>::parameters() const {
  std::vector<PhaseModulus> parameters;
  for (const auto& part : stiffness_.parts) parameters.push_back(part.parameter);
  return parameters;
}

template <int dim>
typename CellComposite<dim>::BasisVectors CellComposite<dim>::no_vectors(Load load) const {
  if constexpr (dim == 3) {
    return {elastic_operator_, stiffness_, load};
  } else {
    return {};
  }
}

template <int dim>
Forces CellComposite<dim>::constant_forces(Load load, const Displacement& displacement) const {
  return forces_under(elastic_operator_, stiffness_.constant, displacement, unit_strain<dim>(load));
}

template <int dim>
Forces CellComposite<dim>::part_forces(std::size_t part, Load load, const Displacement& displacement) const {
  return forces_under(elastic_operator_, stiffness_.parts[part].unit, displacement, unit_strain<dim>(load));
}

template <int dim>
Forces CellComposite<dim>::forces(std::span<const double> parameters, Load load,
                                  const Displacement& displacement) const {
  return forces_under(elastic_operator_, stiffness_.moduli_at(parameters), displacement, unit_strain<dim>(load));
}

template <int dim>
Forces CellComposite<dim>::varying_forces(std::span<const double> parameters, Load load,
                                          const Displacement& displacement) const {
  return forces_under(elastic_operator_, stiffness_.varying_moduli_at(parameters), displacement,
                      unit_strain<dim>(load));
}

template <int dim>
LatticeFields<dim> fields_of(const CellComposite<dim>& composite, const QuasistaticProblem<dim>& problem, Load load,
                             const CompositeState<Displacement>& state) {
  const auto& stiffness = composite.stiffness();
  std::map<PhaseIndex, AppliedModuli> applied;
  for (std::size_t m = 0; m < stiffness.constant.size(); ++m) {
    const auto phase = static_cast<PhaseIndex>(m);
    if (problem.crystals.contains(phase)) continue;
    AppliedModuli moduli = {state.displacement.copy(), state.displacement.copy()};
    moduli.bulk.scale(stiffness.constant[m].bulk);
    moduli.shear.scale(stiffness.constant[m].shear);
    applied.emplace(phase, std::move(moduli));
  }
  for (std::size_t i = 0; i < stiffness.parts.size(); ++i) {
    const auto& part = stiffness.parts[i];
    auto& [bulk, shear] = applied.at(part.phase);
    (part.parameter.modulus == ElasticModulus::shear ? shear : bulk) = state.applied[i].copy();
  }
  return recover_fields(composite.elastic_operator(), problem.discretisation, problem.volumetric, load,
                        state.displacement, applied, problem.crystals);
}

template <int dim>
CellSolver<dim>::CellSolver(const CellComposite<dim>& composite, const LinearOptions& options)
    : composite_(&composite), solver_(make_elastic_solver(composite.elastic_operator(), options)) {}

template <int dim>
void CellSolver<dim>::take(std::span<const double> parameters) {
  moduli_ = composite_->stiffness().moduli_at(parameters);
  solver_->set_moduli(moduli_);
}

template <int dim>
void CellSolver<dim>::prepare(std::span<const double> parameters) {
  take(parameters);
  solver_->update_preconditioner();
}

template <int dim>
Displacement CellSolver<dim>::solve_forces(Load load, const Forces& forces, Displacement guess) {
  return solver_->solve(forces.copy(), std::move(guess), least_energy(load));
}

template <int dim>
void CellSolver<dim>::save_preconditioner(StateWriter& state, const std::string& group) const {
  solver_->save_preconditioner(state, group);
}

template <int dim>
void CellSolver<dim>::restore_preconditioner(const StateReader& state, const std::string& group) {
  solver_->restore_preconditioner(state, group);
}

template <int dim>
Displacement CellSolver<dim>::solve(Load load, Displacement guess) {
  const bool is_strained = composite_->boundary() != Boundary::traction;
  const bool has_voids = std::ranges::any_of(moduli_, [](const Moduli& phase) { return is_void(phase); });
  if (has_voids && !is_strained) require_solid_sides();
  auto forces = is_strained ? held_back(load) : composite_->load_forces(load);
  auto solution = solver_->solve(std::move(forces), std::move(guess), least_energy(load));
  solution.set_macroscopic(is_strained ? 1.0 : 0.0);
  if (has_voids) require_stiffness(load, solution);
  return solution;
}

/// Throws InputError where a void lies at a side of the box, on which the tractions of the boundary act.
template <int dim>
void CellSolver<dim>::require_solid_sides() const {
  const auto& elastic_operator = composite_->elastic_operator();
  bool has_void = false;
  elastic_operator.nodes().for_cells([&](const Index<dim>& cell) {
    const auto& cells = elastic_operator.grid().cells;
    bool is_at_side = false;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      is_at_side = is_at_side || cell[axis] == 0 || cell[axis] == cells[axis] - 1;
    }
    const auto& kinds = elastic_operator.kinds();
    has_void = has_void || (is_at_side && kinds.is_empty(kinds.of(cell), moduli_));
  });
  if (!(parallel::largest(has_void ? 1.0 : 0.0) > 0.0)) return;
  throw InputError(
      "a void lies at a side of the box, on which the boundary \"traction\" presses: expected the boundary "
      "\"displacement\" or \"periodic\", or a box whose sides are solid");
}

/// Throws InputError where voids leave the composite no stiffness under a load, or less than a solver can tell from
/// nothing.
template <int dim>
void CellSolver<dim>::require_stiffness(Load load, const Displacement& solution) const {
  constexpr double least_share = 1e-6;
  const auto& elastic_operator = composite_->elastic_operator();
  const auto forces = forces_under(elastic_operator, moduli_, solution, unit_strain<dim>(load));
  const double energy = work(forces, solution) / elastic_operator.volume();
  const double modulus = composite_->boundary() == Boundary::traction ? 1.0 / energy : energy;
  const auto [bulk, shear] = least_of_solids(moduli_);
  if (modulus > least_share * std::min(bulk, shear)) return;
  throw InputError(
      fmt::format("the composite has no stiffness under the load {} and the boundary {}: voids part its solid",
                  name_of(load), name_of(composite_->boundary())));
}

/// The forces against the uniform strain of a load.
template <int dim>
Forces CellSolver<dim>::held_back(Load load) const {
  const auto& elastic_operator = composite_->elastic_operator();
  auto prescribed = elastic_operator.zero();
  prescribed.set_macroscopic(1.0);
  auto forces = forces_under(elastic_operator, moduli_, prescribed, unit_strain<dim>(load));
  forces.scale(-1.0);
  return forces;
}

/// Twice the energy of a box of one material with the least moduli of all solid phases, under the uniform strain of a
/// load; a smaller value in plane strain under `bulk`. Nothing under a traction boundary, which prescribes no strain.
template <int dim>
std::optional<double> CellSolver<dim>::least_energy(Load load) const {
  if (composite_->boundary() == Boundary::traction) return std::nullopt;
  const auto least = least_of_solids(moduli_);
  const auto modulus = [&least](Load single) { return single == Load::bulk ? least.bulk : least.shear; };
  // The strains of a pair are orthogonal, so that an isotropic body stores the sum of their energies.
  const auto pair = pair_of(load);
  return (pair ? modulus(pair->one) + modulus(pair->other) : modulus(load)) * composite_->elastic_operator().volume();
}

template class CellComposite<2>;
template class CellComposite<3>;
template class CellSolver<2>;
template class CellSolver<3>;
template LatticeFields<2> fields_of(const CellComposite<2>&, const QuasistaticProblem<2>&, Load,
                                    const CompositeState<Displacement>&);
template LatticeFields<3> fields_of(const CellComposite<3>&, const QuasistaticProblem<3>&, Load,
                                    const CompositeState<Displacement>&);

}  // namespace breccia::quasistatic
