#include "quasistatic/reduced/stiff_composite.hpp"

#include <algorithm>

#include "breccia/quasistatic/apparent_moduli.hpp"

namespace breccia {

template <int dim>
void require_stiff(QuasistaticProblem<dim> problem, std::span<const Load> loads) {
  if (std::ranges::none_of(problem.materials, [](const Material& phase) { return is_void(phase); })) return;
  for (auto& material : problem.materials) {
    material.bulk = PronySeries(material.bulk.unrelaxed());
    material.shear = PronySeries(material.shear.unrelaxed());
  }
  static_cast<void>(apparent_moduli(problem, loads));
}

template void require_stiff(QuasistaticProblem<2>, std::span<const Load>);
template void require_stiff(QuasistaticProblem<3>, std::span<const Load>);

}  // namespace breccia
