#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The particles of all fillers, with the number of the filler of each.
struct DrawnParticles {
  std::vector<double> diameters = {};  ///< [m]
  std::vector<std::size_t> fillers = {};
  std::vector<std::optional<double>> size_deviations = {};  ///< size deviation of each filler [-]
};

/// Draws the diameters of all fillers of a stage. Throws as draw_diameters() does. Instantiated for 2 and 3 dimensions.
template <int dim>
DrawnParticles draw_particles(const Stage& stage);

}  // namespace breccia
