#include "quasistatic/operator/mixed_cell.hpp"

#include <utility>

namespace breccia::quasistatic {

/// The value of each mode: that of the deviators, and last that of the volumetric strain.
template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::of_modes(const VolumeAndShear& values) {
  Modes modes = Modes::Constant(values[1]);
  modes[Shape::modes - 1] = values[0];
  return modes;
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::of_all_shares() const {
  VolumeAndShear all = VolumeAndShear::Zero();
  for (const auto& share : rule_.shares()) all += share;
  return of_modes(all);
}

template <int dim>
StrainShare MixedCell<dim>::uniform_share() const {
  const Modes all = of_all_shares();
  return {.volumetric = 1.0 / all[Shape::modes - 1], .deviatoric = 1.0 / all[0]};
}

template <int dim>
Eigen::VectorXd MixedCell<dim>::uniform(const Modes& strain) const {
  return strain.cwiseQuotient(of_all_shares()).replicate(static_cast<Eigen::Index>(mixture().size()) - 1, 1);
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::strain_of(std::size_t part, const Modes& strain,
                                                         const Strains& unknown) const {
  if (part > 0) return segment(part, unknown);
  Modes first = strain;
  for (std::size_t k = 1; k < mixture().size(); ++k) first -= of_share(k).cwiseProduct(segment(k, unknown));
  return first.cwiseQuotient(of_share(0));
}

template <int dim>
std::pair<typename MixedCell<dim>::Modes, Eigen::VectorXd> MixedCell<dim>::stresses(std::span<const Moduli> moduli,
                                                                                    const Modes& strain,
                                                                                    const Strains& unknown) const {
  const auto constrained = rule_.constrained<dim>(moduli);
  const auto stress_in = [&](std::size_t part) -> Modes {
    return of_modes(constrained[part]).cwiseProduct(strain_of(part, strain, unknown));
  };
  const Modes in_first = stress_in(0);
  Eigen::VectorXd forces(unknowns());
  for (std::size_t k = 1; k < mixture().size(); ++k) {
    segment(k, forces) = of_share(k).cwiseProduct(stress_in(k) - in_first);
  }
  return {in_first - of_modes(rule_.constraint(moduli)).cwiseProduct(strain), std::move(forces)};
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::stress_relieved_by(std::span<const Moduli> moduli,
                                                                  const Strains& forces) const {
  const auto constrained = rule_.constrained<dim>(moduli);
  Modes strain = Modes::Zero();
  for (std::size_t k = 1; k < mixture().size(); ++k) {
    strain += segment(k, forces).cwiseQuotient(of_modes(constrained[k]));
  }
  return of_modes(rule_.in_series(constrained)).cwiseProduct(strain);
}

template <int dim>
std::vector<StrainShare> MixedCell<dim>::shares(std::span<const Moduli> moduli) const {
  const auto constrained = rule_.constrained<dim>(moduli);
  const auto whole = rule_.in_series(constrained);
  std::vector<StrainShare> shares;
  for (std::size_t k = 1; k < mixture().size(); ++k) {
    const VolumeAndShear share = whole / constrained[k];
    shares.push_back({.volumetric = share[0], .deviatoric = share[1]});
  }
  return shares;
}

template <int dim>
Eigen::VectorXd MixedCell<dim>::strains_under(std::span<const Moduli> moduli, const Modes& strain,
                                              const Strains& forces) const {
  const auto constrained = rule_.constrained<dim>(moduli);
  const Modes stress = of_modes(rule_.in_series(constrained)).cwiseProduct(strain) - stress_relieved_by(moduli, forces);
  Eigen::VectorXd strains(unknowns());
  for (std::size_t k = 1; k < mixture().size(); ++k) {
    segment(k, strains) =
        (stress + segment(k, forces).cwiseQuotient(of_share(k))).cwiseQuotient(of_modes(constrained[k]));
  }
  return strains;
}

template class MixedCell<2>;
template class MixedCell<3>;

}  // namespace breccia::quasistatic
