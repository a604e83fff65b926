#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace breccia {

enum class ColourScale { linear, logarithmic };

/// A map of one quantity over a square.
struct FieldPicture {
  std::string title = {};
  std::string quantity = {};        ///< with the unit in which its values are written
  double unit_size = 1.0;           ///< in that of the values
  std::size_t columns = 0;          ///< of values, and rows
  std::vector<double> values = {};  ///< row by row from the lower left corner
  ColourScale scale = ColourScale::linear;
};

/// SVG with a map of the values, at most 600 x 600 (above that means of equal squares), a bar of its colours, and what
/// the colours do not show: they go from the 1st to the 99th percentile of the map. On a logarithmic scale what is not
/// positive has the lowest colour. Throws InputError when the values do not fill a square or are not finite.
std::string field_picture(const FieldPicture& picture);

}  // namespace breccia
