#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace breccia {

/// How values are mapped to colours.
enum class ColourScale { linear, logarithmic };

/// A map of one quantity over a square.
struct FieldPicture {
  std::string title = {};
  std::string quantity = {};        ///< with the unit of the labels
  double unit_size = 1.0;           ///< unit of the labels in the unit of the values
  std::size_t columns = 0;          ///< number of columns of values, and of rows
  std::vector<double> values = {};  ///< row by row from the lower left corner
  ColourScale scale = ColourScale::linear;
};

/// SVG with a map of the values, a colour bar, and the smallest and largest value. The map has at most 600 x 600
/// squares; of more values it shows the means over equal squares. The colours range from the 1st to the 99th percentile
/// of the map. On a logarithmic scale values that are not positive get the lowest colour. Throws InputError when the
/// values do not fill a square or are not finite.
std::string field_picture(const FieldPicture& picture);

}  // namespace breccia
