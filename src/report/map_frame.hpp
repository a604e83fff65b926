#pragma once

#include <string>
#include <vector>

#include "report/colour_range.hpp"

namespace breccia {

/// The texts around a map.
struct MapWords {
  std::string title;
  std::string quantity;    ///< name of the quantity, with the unit of the labels
  double unit_size = 1.0;  ///< unit of the labels in the unit of the values
  double side = 0.0;       ///< side of the maps [m], for a scale bar; 0 for none
  DrawnLoad load = DrawnLoad::none;
};

/// A square map in a picture that is 1000 units wide.
struct PlacedMap {
  std::string image;  ///< address of the image (embedded_png)
  double x = 0.0, y = 0.0;
  double side = 1000.0;
  std::string caption = {};   ///< text above the map; empty for none
  std::string outlines = {};  ///< outlines as the data of a path over the unit square, y downwards
};

/// SVG with square maps, a colour bar with marks at round values, a scale bar, the load, and the smallest and largest
/// of their values.
std::string framed_maps(const MapWords& words, const std::vector<PlacedMap>& maps, const std::vector<double>& values,
                        const ColourRange& colours);

}  // namespace breccia
