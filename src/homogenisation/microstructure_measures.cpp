#include "microstructure_measures.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "breccia/microstructure/statistics.hpp"
#include "breccia/study/coatings.hpp"

namespace breccia {

void measure(const Stage& stage, StageMicrostructure& result) {
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
