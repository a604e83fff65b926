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

/// The values of a part, not the first one, among those of all parts except the first.
template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::segment(std::size_t part, const Strains& values) {
  return values.template segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(part) - 1));
}

template <int dim>
Eigen::VectorXd MixedCell<dim>::uniform(const Modes& strain) const {
  return strain.replicate(static_cast<Eigen::Index>(mixture().size()) - 1, 1);
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::strain_of(std::size_t part, const Modes& strain,
                                                         const Strains& unknown) const {
  if (part > 0) return segment(part, unknown);
  Modes first = strain;
  for (std::size_t k = 1; k < mixture().size(); ++k) first -= mixture()[k].fraction * segment(k, unknown);
  return first / mixture().front().fraction;
}

template <int dim>
std::pair<typename MixedCell<dim>::Modes, Eigen::VectorXd> MixedCell<dim>::stresses(std::span<const Moduli> moduli,
                                                                                    const Modes& strain,
                                                                                    const Strains& unknown) const {
  const auto& parts = mixture();
  std::vector<Modes> in_parts;
  in_parts.reserve(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto& of_phase = moduli[parts[part].phase];
    in_parts.push_back(
        of_modes({dilatational_modulus<dim>(of_phase), of_phase.shear}).cwiseProduct(strain_of(part, strain, unknown)));
  }
  for (std::size_t outer = 0; outer + 1 < parts.size(); ++outer) {
    if (!rule_.holds(outer)) continue;
    double inside = 0.0;
    Modes mean = Modes::Zero();
    for (std::size_t inner = outer + 1; inner < parts.size(); ++inner) {
      inside += parts[inner].fraction;
      mean += parts[inner].fraction * strain_of(inner, strain, unknown);
    }
    const Modes held =
        of_modes(MixtureRule::constraint(moduli[parts[outer].phase].shear) / (parts[outer].fraction + inside))
            .cwiseProduct(strain_of(outer, strain, unknown) - mean / inside);
    in_parts[outer] += inside * held;
    for (std::size_t inner = outer + 1; inner < parts.size(); ++inner) in_parts[inner] -= parts[outer].fraction * held;
  }
  Eigen::VectorXd forces(unknowns());
  for (std::size_t k = 1; k < parts.size(); ++k) {
    forces.segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(k) - 1)) =
        parts[k].fraction * (in_parts[k] - in_parts.front());
  }
  return {in_parts.front(), std::move(forces)};
}

template <int dim>
std::vector<typename MixedCell<dim>::Modes> MixedCell<dim>::forces_on_levels(std::span<const MixtureRule::Level> levels,
                                                                             const Strains& forces) const {
  std::vector<Modes> on_levels(mixture().size());
  on_levels.back() = segment(levels.size(), forces);
  for (std::size_t part = levels.size(); part-- > 0;) {
    const auto& [fraction, phase, later, both] = levels[part];
    Modes strain = on_levels[part + 1].cwiseQuotient(of_modes(later));
    if (part > 0) strain += segment(part, forces).cwiseQuotient(of_modes(phase));
    on_levels[part] = of_modes(both).cwiseProduct(strain);
  }
  return on_levels;
}

template <int dim>
typename MixedCell<dim>::Modes MixedCell<dim>::stress_relieved_by(std::span<const Moduli> moduli,
                                                                  const Strains& forces) const {
  return forces_on_levels(rule_.levels<dim>(moduli), forces).front();
}

template <int dim>
std::vector<StrainShare> MixedCell<dim>::shares(std::span<const Moduli> moduli) const {
  const auto levels = rule_.levels<dim>(moduli);
  std::vector<StrainShare> shares;
  VolumeAndShear share = levels.front().both / levels.front().later;
  for (std::size_t part = 1; part < mixture().size(); ++part) {
    VolumeAndShear of_phase = share;
    if (part < levels.size()) {
      of_phase *= levels[part].both / levels[part].phase;
      share *= levels[part].both / levels[part].later;
    }
    shares.push_back({.volumetric = of_phase[0], .deviatoric = of_phase[1]});
  }
  return shares;
}

/// Eq. 41c of the theory, phase by phase: the mean strain of a phase and of those after it becomes the strain of the
/// phase and the mean strain of the others.
template <int dim>
Eigen::VectorXd MixedCell<dim>::strains_under(std::span<const Moduli> moduli, const Modes& strain,
                                              const Strains& forces) const {
  const auto levels = rule_.levels<dim>(moduli);
  const auto on_levels = forces_on_levels(levels, forces);
  Eigen::VectorXd strains(unknowns());
  Modes mean = strain;
  for (std::size_t part = 0; part < levels.size(); ++part) {
    const auto& [fraction, phase, later, both] = levels[part];
    const double of_phase = mixture()[part].fraction;
    const Modes stress = of_modes(both).cwiseProduct(mean) - on_levels[part] / fraction;
    if (part > 0) {
      strains.segment<Shape::modes>(Shape::modes * (static_cast<Eigen::Index>(part) - 1)) =
          (stress + segment(part, forces) / of_phase).cwiseQuotient(of_modes(phase));
    }
    mean = (stress + on_levels[part + 1] / (fraction - of_phase)).cwiseQuotient(of_modes(later));
  }
  strains.tail<Shape::modes>() = mean;
  return strains;
}

template class MixedCell<2>;
template class MixedCell<3>;

}  // namespace breccia::quasistatic
