#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Statistics of the particles of one filler in the box of a stage.
struct FillerStatistics {
  std::size_t particles = 0;
  double fraction = 0.0;          ///< area of the particles per area of the box, or volume per volume [-]
  double coating_fraction = 0.0;  ///< area of the coatings per area of the box, or volume per volume [-]
  std::optional<double> smallest_diameter = {};  ///< diameter without the coating [m]; nothing without particles
  std::optional<double> largest_diameter = {};   ///< diameter without the coating [m]; nothing without particles
  /// Deviation of the drawn from the wanted size distribution [-].
  std::optional<double> size_deviation = std::nullopt;
};

/// The statistics of each filler of a stage, in the order of the fillers, without size deviations. Instantiated for 2
/// and 3 dimensions.
template <int dim>
std::vector<FillerStatistics> filler_statistics(const Stage& stage, const Microstructure<dim>& microstructure);

}  // namespace breccia
