#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "breccia/microstructure/size_distribution.hpp"

namespace breccia {

/// The largest number of particles in a box; more are refused as a mistake, because their packing would run for days.
inline constexpr std::size_t most_particles = 1'000'000;

/// Diameters [m], from the largest down, of balls that fill `fraction` of a box of this side [m] in `dim` dimensions
/// and follow the distribution as closely as whole balls can: each is at the middle of its own slice of the cumulative
/// volume, so that the drawn distribution and the total volume are within one ball of the given ones. Uses no random
/// numbers. Throws InputError if a bound of the distribution is 0 or infinite, NumericalError if less than one ball or
/// more than most_particles would be drawn. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] std::vector<double> draw_diameters(const SizeDistribution& distribution, double fraction, double side);

/// Largest difference between the distribution and that of balls with these diameters [m], both by volume (in 2D: by
/// area). Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] double largest_deviation(const SizeDistribution& distribution, std::span<const double> diameters);

}  // namespace breccia
