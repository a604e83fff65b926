#include "quasistatic/operator/mixed_cell.hpp"

#include <utility>

namespace breccia::quasistatic {
namespace {

/// The modulus of each mode: the shear modulus of the deviators, the dilatational modulus of the volumetric strain.
template <int dim>
typename CellShape<dim>::ModeValues of_modes(const Moduli& moduli) {
  typename CellShape<dim>::ModeValues values;
  values.setConstant(moduli.shear);
  values[CellShape<dim>::modes - 1] = dilatational_modulus<dim>(moduli);
  return values;
}

}  // namespace

template <int dim>
Eigen::VectorXd MixedCell<dim>::uniform(const Modes& strain) const {
  return strain.replicate(static_cast<Eigen::Index>(mixture_.size()) - 1, 1);
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::strain_of(std::size_t part, const Modes& strain,
                                                         const Strains& unknown) const {
  const auto of_part = [&](std::size_t k) {
    return unknown.template segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(k) - 1));
  };
  if (part > 0) return of_part(part);
  Modes first = strain;
  for (std::size_t k = 1; k < mixture_.size(); ++k) first -= mixture_[k].fraction * of_part(k);
  return first / mixture_.front().fraction;
}

template <int dim>
std::pair<typename MixedCell<dim>::Modes, Eigen::VectorXd> MixedCell<dim>::stresses(std::span<const Moduli> moduli,
                                                                                    const Modes& strain,
                                                                                    const Strains& unknown) const {
  const auto stress_in = [&](std::size_t part) -> Modes {
    return of_modes<dim>(moduli[mixture_[part].phase]).cwiseProduct(strain_of(part, strain, unknown));
  };
  const Modes first = stress_in(0);
  Eigen::VectorXd forces(unknowns());
  for (std::size_t k = 1; k < mixture_.size(); ++k) {
    forces.segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(k) - 1)) =
        mixture_[k].fraction * (stress_in(k) - first);
  }
  return {first, std::move(forces)};
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::stress_relieved_by(std::span<const Moduli> moduli,
                                                                  const Strains& forces) const {
  Modes strain = Modes::Zero();
  for (std::size_t k = 1; k < mixture_.size(); ++k) {
    strain += forces.template segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(k) - 1))
                  .cwiseQuotient(of_modes<dim>(moduli[mixture_[k].phase]));
  }
  return of_modes<dim>(series_moduli<dim>(mixture_, moduli)).cwiseProduct(strain);
}

template <int dim>
std::vector<StrainShare> MixedCell<dim>::shares(std::span<const Moduli> moduli) const {
  const auto of_cell = series_moduli<dim>(mixture_, moduli);
  std::vector<StrainShare> shares;
  for (std::size_t k = 1; k < mixture_.size(); ++k) {
    const auto& of_phase = moduli[mixture_[k].phase];
    shares.push_back({.volumetric = dilatational_modulus<dim>(of_cell) / dilatational_modulus<dim>(of_phase),
                      .deviatoric = of_cell.shear / of_phase.shear});
  }
  return shares;
}

template <int dim>
Eigen::VectorXd MixedCell<dim>::strains_under(std::span<const Moduli> moduli, const Modes& strain,
                                              const Strains& forces) const {
  // All phases have the stress of the first one, apart from the forces on them: M_k y_k = t + phi_k / f_k.
  const Modes stress =
      of_modes<dim>(series_moduli<dim>(mixture_, moduli)).cwiseProduct(strain) - stress_relieved_by(moduli, forces);
  Eigen::VectorXd strains(unknowns());
  for (std::size_t k = 1; k < mixture_.size(); ++k) {
    const auto index = Shape::modes * (static_cast<Eigen::Index>(k) - 1);
    strains.segment<Shape::modes>(index) =
        (stress + forces.template segment<Shape::modes>(index) / mixture_[k].fraction)
            .cwiseQuotient(of_modes<dim>(moduli[mixture_[k].phase]));
  }
  return strains;
}

template class MixedCell<2>;
template class MixedCell<3>;

}  // namespace breccia::quasistatic
