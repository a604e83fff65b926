#pragma once

#include <cstddef>
#include <variant>

#include "breccia/microstructure/label_image.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/shaped_particles.hpp"

namespace breccia {

/// Diameters [m] of discs of the areas of grains, or of cells, below which a share of their whole area is; in three
/// dimensions of balls of their volumes, and a share of the whole volume.
struct SizesByArea {
  double of_a_tenth = 0.0;
  double of_half = 0.0;
};

/// The films between grains and what they leave of the grains, in a box of either dimension.
struct GrainStatistics {
  double film = 0.0;           ///< thickness [m]
  std::size_t count = 0;       ///< grains that the films leave
  std::size_t cell_count = 0;  ///< grains with those of which the films leave nothing
  SizesByArea cells = {};      ///< grains with half of the films around them
  SizesByArea sizes = {};      ///< of the grains that the films leave
  /// Length of the films shorter than five times their thickness over that of all films [-]; 0 in three dimensions.
  double short_films = 0.0;
};

/// Grains that fill a box, parted by films of the matrix.
template <int dim>
struct Grains {
  LaguerreSites<dim> sites;
  GrainStatistics statistics = {};
};

/// A square or cubic box by what fills it. Each content knows the side and the walls of its box.
template <int dim>
using Box = std::variant<Microstructure<dim>, ShapedParticles<dim>, Grains<dim>, SharedImage<dim>>;

}  // namespace breccia
