#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions. In 2D a volume is an area and a surface a length.

/// One cell of a tessellation, and its grain without the film.
template <int dim>
struct GrainGeometry {
  Vector<dim> centroid;    ///< centroid of the cell; inside the box if the walls are hard [m]
  double cell_volume;      ///< volume of the cell [m^dim]
  double grain_volume;     ///< volume of the grain; 0 if the film takes up the whole cell [m^dim]
  double grain_surface;    ///< surface of the grain [m^(dim - 1)]
  double diameter;         ///< diameter of the ball with the grain's volume [m]
  double aspect_ratio;     ///< aspect ratio of the cell, from its second moments [-]
  std::size_t faces;       ///< number of faces of the cell, without those on a wall
  std::size_t neighbours;  ///< number of other sites behind these faces; in a small periodic box two faces may have the
                           ///< same one
};

/// The statistics of all grains, by site. `film` is the thickness of the film [m].
template <int dim>
[[nodiscard]] std::vector<GrainGeometry<dim>> grain_geometries(const Tessellation<dim>& tessellation, double film);

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation
  double smallest = 0.0;
  double largest = 0.0;
};

struct TessellationStatistics {
  std::size_t grains = 0;     ///< number of cells
  std::size_t vanished = 0;   ///< number of cells that the film takes up completely
  double fraction = 0.0;      ///< volume of the grains per volume of the box [-]
  double film_surface = 0.0;  ///< middle surface of the films per volume of the box [1/m]
  Spread cell_volume;         ///< volumes of the cells [m^dim]
  Spread diameter;            ///< diameters of the balls with the grains' volumes [m]
  Spread aspect_ratio;        ///< [-]
  /// Mean number of faces of a cell: 6 in a periodic box where three films meet in each point (Euler).
  double mean_faces = 0.0;
};

template <int dim>
[[nodiscard]] TessellationStatistics statistics(const Tessellation<dim>& tessellation, double film);

/// Largest relative difference of the volume of a cell from the wanted one; `volumes` are proportional to the wanted
/// volumes. Throws InputError if there is not one for each site.
template <int dim>
[[nodiscard]] double largest_volume_error(const Tessellation<dim>& tessellation, std::span<const double> volumes);

}  // namespace breccia
