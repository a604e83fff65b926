#pragma once

#include <array>
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

/// Maps of one quantity over the middle planes of a cube.
struct FieldCutsPicture {
  std::string title = {};
  std::string quantity = {};  ///< with the unit of the labels
  double unit_size = 1.0;     ///< unit of the labels in the unit of the values
  std::size_t columns = 0;    ///< number of columns of values of each cut, and of rows
  /// By the axis along which a plane is seen. The axis that follows it in the cycle x, y, z runs to the right, the one
  /// before it upwards; row by row from the lower left corner.
  std::array<std::vector<double>, 3> cuts = {};
  ColourScale scale = ColourScale::linear;
};

/// SVG with a map of the values, a colour bar, and the smallest and largest value. The map has at most 600 x 600
/// squares; of more values it shows the means over equal squares. The colours range from the 1st to the 99th percentile
/// of the map. On a logarithmic scale values that are not positive get the lowest colour. Throws InputError when the
/// values do not fill a square or are not finite.
std::string field_picture(const FieldPicture& picture);

/// The same with a map for each of the three cuts, in one range of colours; of more than 300 x 300 values the means.
/// Throws InputError.
std::string field_cuts_picture(const FieldCutsPicture& picture);

}  // namespace breccia
