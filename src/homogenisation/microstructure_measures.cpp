#include "microstructure_measures.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/tessellation_statistics.hpp"
#include "breccia/study/coatings.hpp"

namespace breccia {

namespace {

void measure_grains(StageMicrostructure& result) {
  auto& [sites, film, count] = *result.grains;
  const Tessellation<2> tessellation(sites);
  const auto [grains, vanished, fraction, film_surface, cell_volume, diameter, aspect_ratio, neighbours] =
      statistics(tessellation, film);
  count = grains - vanished;
  result.fraction = fraction;
  result.interface_per_area = 2.0 * film_surface;
  result.gap = film;
  result.wall_gap = sites.walls == Walls::hard ? 0.5 * film : std::numeric_limits<double>::infinity();
  const auto deviation = result.fillers.empty() ? std::nullopt : result.fillers.front().size_deviation;
  result.fillers = {{.particles = count,
                     .fraction = fraction,
                     .smallest_diameter = diameter.smallest,
                     .largest_diameter = diameter.largest,
                     .size_deviation = deviation}};
}

}  // namespace

void measure(const Stage& stage, StageMicrostructure& result) {
  if (result.grains) {
    measure_grains(result);
    return;
  }
  const auto coated = with_coatings(stage, result.microstructure);
  result.fraction = volume_fraction(result.microstructure);
  result.interface_per_area = specific_surface(result.microstructure);
  result.gap = smallest_gap(coated);
  result.wall_gap = smallest_wall_gap(coated);
  auto fillers = filler_statistics(stage, result.microstructure);
  for (std::size_t number = 0; number < std::min(fillers.size(), result.fillers.size()); ++number) {
    fillers[number].size_deviation = result.fillers[number].size_deviation;
  }
  result.fillers = std::move(fillers);
}

}  // namespace breccia
