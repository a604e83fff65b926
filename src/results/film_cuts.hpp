#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/films/film_fields.hpp"

namespace breccia {

/// A convex polygon that shows a cell of fields of grains and films in a map.
struct CellPolygon {
  std::size_t cell = 0;                        ///< index of the cell
  std::vector<std::array<double, 2>> corners;  ///< corners [m]
};

/// The polygons of the cells in the plane.
[[nodiscard]] std::vector<CellPolygon> polygons_of(const FilmFields<2>& fields, double side);
/// The polygons in which the plane halfway up a periodic box of this side [m] cuts the cells in space, and their images
/// above and below: the axes of the map are x and y.
[[nodiscard]] std::vector<CellPolygon> polygons_of(const FilmFields<3>& fields, double side);

}  // namespace breccia
