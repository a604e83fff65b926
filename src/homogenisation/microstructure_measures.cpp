#include "microstructure_measures.hpp"

#include "breccia/microstructure/statistics.hpp"

namespace breccia {

void measure(StageMicrostructure& result) {
  result.fraction = volume_fraction(result.microstructure);
  result.interface_per_area = specific_surface(result.microstructure);
  result.gap = smallest_gap(result.microstructure);
  result.wall_gap = smallest_wall_gap(result.microstructure);
}

}  // namespace breccia
