#include "reduced/cell_composite.hpp"

#include "operator/recovery.hpp"

namespace breccia::quasistatic {

CellComposite::CellComposite(const QuasistaticProblem& problem, std::span<const VaryingPhase> varying)
    : stiffness_(affine_stiffness(problem.materials, varying)),
      elastic_operator_(problem.discretisation, problem.volumetric, problem.boundary) {}

std::vector<PhaseModulus> CellComposite::parameters() const {
  std::vector<PhaseModulus> parameters;
  for (const auto& part : stiffness_.parts) parameters.push_back(part.parameter);
  return parameters;
}

Forces CellComposite::constant_forces(Load load, const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.constant, load, displacement);
}

Forces CellComposite::part_forces(std::size_t part, Load load, const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.parts[part].unit, load, displacement);
}

Forces CellComposite::forces(std::span<const double> parameters, Load load, const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.moduli_at(parameters), load, displacement);
}

Forces CellComposite::varying_forces(std::span<const double> parameters, Load load,
                                     const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.varying_moduli_at(parameters), load, displacement);
}

PointFields<2> fields_of(const CellComposite& composite, const QuasistaticProblem& problem, Load load,
                         const CompositeState<Displacement>& state) {
  const auto& stiffness = composite.stiffness();
  std::vector<AppliedModuli> applied;
  for (const auto& [bulk, shear] : stiffness.constant) {
    applied.push_back({state.displacement.copy(), state.displacement.copy()});
    applied.back().bulk.scale(bulk);
    applied.back().shear.scale(shear);
  }
  for (std::size_t i = 0; i < stiffness.parts.size(); ++i) {
    const auto& part = stiffness.parts[i];
    auto& [bulk, shear] = applied[part.phase];
    (part.parameter.modulus == ElasticModulus::shear ? shear : bulk) = state.applied[i].copy();
  }
  return recover_fields(composite.elastic_operator(), problem.discretisation, problem.volumetric, load,
                        state.displacement, applied);
}

CellSolver::CellSolver(const CellComposite& composite, const LinearOptions& options)
    : composite_(&composite), solver_(make_elastic_solver(composite.elastic_operator(), options)) {}

void CellSolver::take(std::span<const double> parameters) {
  moduli_ = composite_->stiffness().moduli_at(parameters);
  solver_->set_moduli(moduli_);
}

void CellSolver::prepare(std::span<const double> parameters) {
  take(parameters);
  solver_->update_preconditioner();
}

Displacement CellSolver::solve_forces(const Forces& forces, Displacement guess) {
  solver_->solve(forces, guess);
  return guess;
}

void CellSolver::save_preconditioner(StateWriter& state, const std::string& group) const {
  solver_->save_preconditioner(state, group);
}

void CellSolver::restore_preconditioner(const StateReader& state, const std::string& group) {
  solver_->restore_preconditioner(state, group);
}

Displacement CellSolver::solve(Load load, Displacement guess) {
  const auto& elastic_operator = composite_->elastic_operator();
  auto forces = elastic_operator.zero();
  double macroscopic = 0.0;
  if (elastic_operator.boundary() == Boundary::traction) {
    forces = elastic_operator.load_forces(load);
  } else {
    macroscopic = 1.0;
    auto prescribed = elastic_operator.zero();
    prescribed.set_macroscopic(macroscopic);
    forces.add(-1.0, elastic_operator.forces(moduli_, load, prescribed));
  }
  solver_->solve(forces, guess);
  guess.set_macroscopic(macroscopic);
  return guess;
}

}  // namespace breccia::quasistatic
