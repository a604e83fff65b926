#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// A site of a Laguerre tessellation, from which a grain grows.
template <int dim>
struct Site {
  Vector<dim> position{};  ///< [m]
  double weight = 0.0;     ///< weight; the larger it is, the larger is the grain [m^2]
};

/// The film along hard walls.
enum class WallFilm {
  half,  ///< half a film: the grains keep off the walls
  none   ///< no film: the walls cut grains and films, as the sides of a window in a larger body do
};

/// The sites of a Laguerre tessellation (power diagram) of the box [0, side]^dim: a point x belongs to the site with
/// the least |x - position|^2 - weight (theory, Eq. 48). In a periodic box all images of a site count; hard walls cut
/// the cells. Adding a number to all weights changes nothing.
template <int dim>
struct LaguerreSites {
  double side = 0.0;  ///< [m]
  Walls walls = Walls::periodic;
  std::vector<Site<dim>> sites;
  WallFilm wall_film = WallFilm::half;  ///< film along the walls; unused in a periodic box
  /// Ratio of the thickness of the films around the grain of each site to that of the tessellation [-]; a film between
  /// two grains has the mean ratio of both grains, a film along a wall the ratio of its grain. Empty where all ratios
  /// are 1.
  std::vector<double> film_shares = {};
};

/// A mistake in one site.
struct SiteMistake {
  std::size_t site;  ///< number of the site, from 0
  std::string text;
};

/// The mistakes of all sites, in their order: a position outside the box, a weight that is not finite, a share of the
/// films that is not positive; if there are none of these, the sites to which no point belongs. Throws InputError if
/// the box has no size, there are no sites or more than most_particles, or the numbers of shares and sites differ.
/// Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] std::vector<SiteMistake> mistakes(const LaguerreSites<dim>& sites);

}  // namespace breccia
