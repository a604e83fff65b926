#include "reduced/cell_composite.hpp"

namespace breccia::quasistatic {

template <int dim>
CellComposite<dim>::CellComposite(const QuasistaticProblem<dim>& problem, std::span<const VaryingPhase> varying)
    : stiffness_(affine_stiffness(problem.materials, varying)),
      elastic_operator_(problem.discretisation, problem.volumetric, problem.boundary) {}

template <int dim>
std::vector<PhaseModulus> CellComposite<dim>::parameters() const {
  std::vector<PhaseModulus> parameters;
  for (const auto& part : stiffness_.parts) parameters.push_back(part.parameter);
  return parameters;
}

template <int dim>
Forces CellComposite<dim>::constant_forces(Load load, const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.constant, load, displacement);
}

template <int dim>
Forces CellComposite<dim>::part_forces(std::size_t part, Load load, const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.parts[part].unit, load, displacement);
}

template <int dim>
Forces CellComposite<dim>::forces(std::span<const double> parameters, Load load,
                                  const Displacement& displacement) const {
  return elastic_operator_.forces(stiffness_.moduli_at(parameters), load, displacement);
}

template <int dim>
CellSolver<dim>::CellSolver(const CellComposite<dim>& composite, const LinearOptions& options)
    : composite_(&composite), solver_(make_elastic_solver(composite.elastic_operator(), options)) {}

template <int dim>
void CellSolver<dim>::prepare(std::span<const double> parameters) {
  moduli_ = composite_->stiffness().moduli_at(parameters);
  solver_->set_moduli(moduli_);
  solver_->update_preconditioner();
}

template <int dim>
Displacement CellSolver<dim>::solve(Load load, Displacement guess) {
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

template class CellComposite<2>;
template class CellComposite<3>;
template class CellSolver<2>;
template class CellSolver<3>;

}  // namespace breccia::quasistatic
