#pragma once

#include <cstdint>
#include <vector>

#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia {

/// A random tessellation to be made: the sizes of its cells, and its box.
struct RandomTessellationRequest {
  double side = 0.0;  ///< side of the box [0, side]^dim [m]
  Walls walls = Walls::periodic;
  /// Diameters of balls with the volumes (in 2D: the areas) of the cells [m]. Only their ratios matter, since the
  /// volumes are scaled so that the cells fill the box.
  std::vector<double> diameters;
  std::uint64_t seed = 1;  ///< seed of the random numbers; a seed always gives the same tessellation
  /// Number of times that every site moves to the centroid of its cell. Each step makes the cells rounder; without any
  /// step they are as irregular as the random positions (Bourne, Kok, Roper, Spanjer 2020).
  int centring_steps = 5;
  double tolerance = 1e-9;  ///< largest relative error of the volume of a cell [-]
};

/// Sites, in the order of the diameters, whose tessellation has cells of these sizes at random positions. Throws
/// InputError on meaningless arguments, NumericalError if roundoff keeps the volumes from the tolerance. Instantiated
/// for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] LaguerreSites<dim> random_sites(const RandomTessellationRequest& request);

}  // namespace breccia
