#pragma once

#include <cstddef>
#include <variant>

#include "breccia/microstructure/label_image.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/microstructure/shaped_particles.hpp"

namespace breccia {

/// Quantiles of the sizes of grains or cells, weighted by area: the diameters [m] below which a tenth and a half of the
/// whole area lie. The diameter of a grain is that of the disc of the same area. In three dimensions volumes and balls
/// are in place of areas and discs.
struct SizesByArea {
  double of_a_tenth = 0.0;
  double of_half = 0.0;
};

/// Statistics of the films between grains and of the grains without these films, in a box of two or three dimensions.
struct GrainStatistics {
  double film = 0.0;      ///< thickness [m]
  std::size_t count = 0;  ///< number of grains that are larger than the films around them
  /// Number of cells of the tessellation: the grains, and cells that films fill completely.
  std::size_t cell_count = 0;
  SizesByArea cells = {};  ///< sizes of the cells, that is, of grains with half of the films around them
  SizesByArea sizes = {};  ///< sizes of the grains without films
  /// Length of the films shorter than five times their thickness over that of all films [-]; 0 in three dimensions.
  double short_films = 0.0;
  std::size_t debonded_films = 0;  ///< number of films that are debonded
  double debonded = 0.0;           ///< their share of the area of all films, in the plane of their length [-]
};

/// Grains that fill a box, separated by films of the matrix.
template <int dim>
struct Grains {
  LaguerreSites<dim> sites;
  GrainStatistics statistics = {};
};

/// The content of a square or cubic box: balls, particles of other shapes, grains or an image. Each alternative holds
/// the side and the walls of its box.
template <int dim>
using Box = std::variant<Microstructure<dim>, ShapedParticles<dim>, Grains<dim>, SharedImage<dim>>;

}  // namespace breccia
