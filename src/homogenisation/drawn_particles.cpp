#include "drawn_particles.hpp"

#include <fmt/format.h>

#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/study/filler_sizes.hpp"

#include "named_errors.hpp"

namespace breccia {
namespace {

/// The diameters of a filler [m]. What is wrong names the filler where there are several.
std::vector<double> draw_diameters_of(const Stage& stage, std::size_t number) {
  const auto& filler = stage.fillers[number];
  const auto distribution = distribution_of(filler);
  if (!distribution) return std::get<ListedSizes>(filler.sizes.value()).diameters;
  const auto draw = [&] {
    const double fraction = filler.fraction.value();
    return stage.dimensions == 3 ? draw_diameters<3>(*distribution, fraction, stage.side)
                                 : draw_diameters<2>(*distribution, fraction, stage.side);
  };
  if (stage.fillers.size() == 1) return draw();
  return name_errors(fmt::format("filler {}, {}", number, filler.material.name), draw);
}

}  // namespace

DrawnParticles draw_particles(const Stage& stage) {
  DrawnParticles drawn;
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto diameters = draw_diameters_of(stage, number);
    auto& deviation = drawn.size_deviations.emplace_back();
    if (const auto distribution = distribution_of(stage.fillers[number])) {
      deviation = stage.dimensions == 3 ? largest_deviation<3>(*distribution, diameters)
                                        : largest_deviation<2>(*distribution, diameters);
    }
    drawn.diameters.insert(drawn.diameters.end(), diameters.begin(), diameters.end());
    drawn.fillers.resize(drawn.diameters.size(), number);
  }
  return drawn;
}

}  // namespace breccia
