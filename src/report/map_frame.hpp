#pragma once

#include <string>
#include <vector>

#include "colour_range.hpp"

namespace breccia {

/// What stands around a map.
struct MapWords {
  std::string title;
  std::string quantity;    ///< with the unit of the labels
  double unit_size = 1.0;  ///< unit of the labels in the unit of the values
};

/// SVG with a square map, a colour bar, and the smallest and largest of its values. `map` is the address of the image
/// (embedded_png).
std::string framed_map(const MapWords& words, const std::string& map, const std::vector<double>& values,
                       const ColourRange& colours);

}  // namespace breccia
