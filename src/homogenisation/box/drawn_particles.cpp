#include "homogenisation/box/drawn_particles.hpp"

#include <fmt/format.h>

#include "breccia/microstructure/draw_diameters.hpp"

#include "homogenisation/run/named_errors.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The diameters of a filler [m]. Error messages name the filler where there are several.
template <int dim>
std::vector<double> draw_diameters_of(const Stage& stage, std::size_t number) {
  const auto& filler = stage.fillers[number];
  const auto distribution = distribution_of(filler);
  if (!distribution) return std::get<ListedSizes>(filler.sizes.value()).diameters;
  const auto draw = [&] { return draw_diameters<dim>(*distribution, filler.fraction.value(), stage.side); };
  if (stage.fillers.size() == 1) return draw();
  return name_errors(fmt::format("filler {}, {}", number, filler.material.name), draw);
}

}  // namespace

template <int dim>
DrawnParticles draw_particles(const Stage& stage) {
  DrawnParticles drawn;
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto diameters = draw_diameters_of<dim>(stage, number);
    auto& deviation = drawn.size_deviations.emplace_back();
    if (const auto distribution = distribution_of(stage.fillers[number])) {
      deviation = largest_deviation<dim>(*distribution, diameters);
    }
    drawn.diameters.insert(drawn.diameters.end(), diameters.begin(), diameters.end());
    drawn.fillers.resize(drawn.diameters.size(), number);
  }
  return drawn;
}

template DrawnParticles draw_particles<2>(const Stage&);
template DrawnParticles draw_particles<3>(const Stage&);

}  // namespace breccia
