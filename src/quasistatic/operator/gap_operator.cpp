#include "quasistatic/operator/gap_operator.hpp"

#include <cstddef>

namespace breccia::quasistatic {

template <int dim>
typename GapOperator<dim>::Unknowns GapOperator<dim>::unknowns(const typename Shape::Values& of_nodes,
                                                               const GapLayout& layout,
                                                               std::span<const double> of_gaps) const noexcept {
  Unknowns unknowns = Unknowns::Zero();
  unknowns.template head<Shape::dofs>() = of_nodes;
  for (std::size_t k = 0; k < cell_->gap_unknowns.size(); ++k) {
    const auto number = cell_->gap_unknowns[k];
    if (number != gaps::GapCell<dim>::none)
      unknowns[Shape::dofs + static_cast<Eigen::Index>(k)] = of_gaps[layout.index_of(number)];
  }
  return unknowns;
}

template <int dim>
typename GapOperator<dim>::Modes GapOperator<dim>::strain(const Unknowns& unknowns) const noexcept {
  Modes strain = *modes_ * unknowns.template head<Shape::dofs>();
  strain[Shape::modes - 1] = volume(unknowns);
  return strain;
}

template <int dim>
void GapOperator<dim>::add_forces_of(const Modes& stress, Unknowns& forces) const noexcept {
  forces.template head<Shape::dofs>() +=
      modes_->template topRows<Shape::modes - 1>().transpose() * stress.template head<Shape::modes - 1>();
  forces += stress[Shape::modes - 1] * cell_->volume;
}

template <int dim>
void GapOperator<dim>::add_forces_of_terms(std::span<const Moduli> moduli, const Unknowns& unknowns,
                                           Unknowns& forces) const noexcept {
  for (const auto& [phase, factor, form] : cell_->terms) {
    form.add_to(forces, factor * moduli[phase].shear * form.of(unknowns));
  }
}

template <int dim>
void GapOperator<dim>::add_to_gaps(const Unknowns& forces, const GapLayout& layout,
                                   std::span<double> on_gaps) const noexcept {
  for (std::size_t k = 0; k < cell_->gap_unknowns.size(); ++k) {
    const auto number = cell_->gap_unknowns[k];
    if (number != gaps::GapCell<dim>::none)
      on_gaps[layout.index_of(number)] += forces[Shape::dofs + static_cast<Eigen::Index>(k)];
  }
}

template <int dim>
typename GapOperator<dim>::Stiffness GapOperator<dim>::stiffness(const Moduli& of_cell,
                                                                 std::span<const Moduli> moduli) const {
  Modes weights = Modes::Constant(of_cell.shear);
  weights[Shape::modes - 1] = dilatational_modulus<dim>(of_cell);
  Stiffness stiffness;
  for (Eigen::Index column = 0; column < gaps::unknowns_of_cell<dim>; ++column) {
    const Unknowns unit = Unknowns::Unit(column);
    Unknowns forces = Unknowns::Zero();
    add_forces_of(weights.cwiseProduct(strain(unit)), forces);
    add_forces_of_terms(moduli, unit, forces);
    stiffness.col(column) = forces;
  }
  return stiffness;
}

template class GapOperator<2>;
template class GapOperator<3>;

}  // namespace breccia::quasistatic
