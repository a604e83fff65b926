#include "study/coatings.hpp"

#include <algorithm>

namespace breccia {

template <int dim>
Microstructure<dim> with_coatings(const Stage& stage, Microstructure<dim> microstructure) {
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    // A thickness that is not positive is a mistake of the coating, which is reported as such.
    const double thickness = std::max(0.0, filler_of(stage, microstructure, particle).coating_thickness());
    microstructure.particles[particle].diameter += 2.0 * thickness;
  }
  return microstructure;
}

template Microstructure<2> with_coatings(const Stage&, Microstructure<2>);
template Microstructure<3> with_coatings(const Stage&, Microstructure<3>);

std::optional<double> thinnest_coating(const Stage& stage) {
  std::optional<double> thinnest;
  for (const auto& filler : stage.fillers) {
    if (!filler.coating) continue;
    thinnest = std::min(thinnest.value_or(filler.coating->thickness), filler.coating->thickness);
  }
  return thinnest;
}

}  // namespace breccia
