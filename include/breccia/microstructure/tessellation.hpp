#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/convex_cell.hpp"
#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions. In 2D a volume is an area and a surface a length.

/// A Laguerre tessellation: convex cells that fill a box, one for each site. With a film of uniform thickness t between
/// the cells, the grain of a cell is the set of points whose distance from all its faces is at least t/2; so every film
/// is t thick between two grains and t/2 along a hard wall (theory, Eq. 49). Where the walls have no film, their faces
/// do not count. Where the sites have shares of the films (LaguerreSites::film_shares), the film of each face is t
/// times the mean share of the two grains.
template <int dim>
class Tessellation {
 public:
  /// Throws InputError that lists the mistakes of the sites (see mistakes()).
  explicit Tessellation(LaguerreSites<dim> sites);

  [[nodiscard]] double side() const noexcept { return sites_.side; }  ///< side of the box [m]
  [[nodiscard]] Walls walls() const noexcept { return sites_.walls; }
  [[nodiscard]] const LaguerreSites<dim>& sites() const noexcept { return sites_; }
  [[nodiscard]] std::size_t size() const noexcept { return cells_.size(); }  ///< number of grains
  /// The cell of a site, relative to its position; in a periodic box it may reach beyond the sides.
  [[nodiscard]] const ConvexCell<dim>& cell(std::size_t site) const { return cells_[site]; }
  /// The grain of a site, that is, its cell without its share of a film of this thickness [m], relative to the position
  /// of the site. Empty if the film takes up the whole cell.
  [[nodiscard]] ConvexCell<dim> grain(std::size_t site, double film) const;
  /// The site beyond a face of a cell (it may be an image of the cell's own site); none beyond a wall.
  [[nodiscard]] static std::optional<std::size_t> neighbour(const HalfSpace<dim>& face) noexcept;
  /// Half of the thickness of the film at a face of the cell of a site, if the film of the tessellation has this
  /// thickness [m]; 0 at a wall without a film.
  [[nodiscard]] double half_film(std::size_t site, const HalfSpace<dim>& face, double film) const;
  /// Whether a film runs along this face: along all faces except walls without a film.
  [[nodiscard]] bool recedes(const HalfSpace<dim>& face) const noexcept {
    return sites_.wall_film == WallFilm::half || neighbour(face).has_value();
  }
  /// Displacement of the image of the site beyond the face along each axis, in units of the side of the box: -1, 0 or
  /// 1; zero for a wall.
  [[nodiscard]] static Index<dim> image(const HalfSpace<dim>& face) noexcept;

 private:
  LaguerreSites<dim> sites_;
  std::vector<ConvexCell<dim>> cells_;
};

/// Volumes of the cells [m^dim], by site.
template <int dim>
[[nodiscard]] std::vector<double> cell_volumes(const Tessellation<dim>& tessellation);

/// Volume of the grains per volume of the box, if the film has this thickness [m]. Throws InputError if the thickness
/// is negative or not finite.
template <int dim>
[[nodiscard]] double grain_fraction(const Tessellation<dim>& tessellation, double film);

/// Thickness of the film [m] with which the grains fill this fraction of the box, to rounding. Throws InputError unless
/// the fraction is above 0 and at most 1.
template <int dim>
[[nodiscard]] double film_thickness(const Tessellation<dim>& tessellation, double fraction);

}  // namespace breccia
