#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/field_picture.hpp"

namespace breccia {

/// A convex polygon in a map.
struct MapPolygon {
  std::vector<std::array<double, 2>> corners;  ///< corners [m]
  std::optional<double> value = {};            ///< value; a polygon without a value is grey or, as a gap, red
  bool is_gap = false;
};

/// A map of one quantity on polygons in a square box.
struct PolygonPicture {
  std::string title = {};
  std::string quantity = {};  ///< name of the quantity, with the unit of the labels
  double unit_size = 1.0;     ///< unit of the labels in the unit of the values
  ColourScale scale = ColourScale::linear;
  double side = 0.0;         ///< side of the box [m], which reaches from the origin to (side, side)
  bool is_periodic = false;  ///< whether the parts beyond a side are drawn again at the opposite one
  DrawnLoad load = DrawnLoad::none;
  std::vector<MapPolygon> polygons = {};  ///< polygons; later ones are drawn above earlier ones
};

/// SVG with a map of the polygons, a colour bar, and the smallest and largest value of its pixels. The map has 1000 x
/// 1000 pixels. Polygons are drawn half a pixel larger all around, so that a thin film is not lost. The colours range
/// from the 1st to the 99th percentile of the pixels with a value. On a logarithmic scale values that are not positive
/// get the lowest colour. Throws InputError when the side is not positive, a value or a corner is not finite, or no
/// pixel has a value.
[[nodiscard]] std::string polygon_picture(const PolygonPicture& picture);

}  // namespace breccia
