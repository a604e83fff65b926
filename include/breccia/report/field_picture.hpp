#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// How values are mapped to colours. A diverging scale is linear with light grey at zero, and another hue on each side.
enum class ColourScale { linear, logarithmic, diverging };

/// How the box of a map is loaded, which a small picture below it shows.
enum class DrawnLoad { none, shear, stretch, dilatation };

/// A map of one quantity over a square.
struct FieldPicture {
  std::string title = {};
  std::string quantity = {};        ///< with the unit of the labels
  double unit_size = 1.0;           ///< unit of the labels in the unit of the values
  std::size_t columns = 0;          ///< number of columns of values, and of rows
  std::vector<double> values = {};  ///< row by row from the lower left corner
  ColourScale scale = ColourScale::linear;
  double side = 0.0;  ///< of the square [m], for a scale bar; 0 for none
  DrawnLoad load = DrawnLoad::none;
  std::vector<std::uint8_t> phases = {};  ///< of the values, whose outlines are drawn; or none
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
  double side = 0.0;  ///< of the cube [m], for a scale bar; 0 for none
};

/// SVG with a map of the values, a colour bar, a scale bar, and the smallest and largest value. The map has at most 600
/// x 600 squares; of more values it shows the means over equal squares. The colours range from the 1st to the 99th
/// percentile of the map. On a logarithmic scale values that are not positive get the lowest colour. Where values of
/// both signs have a part in a linear scale, it is a diverging one. Throws InputError when the values, or the phases if
/// there are any, do not fill a square, or a value is not finite.
std::string field_picture(const FieldPicture& picture);

/// The same with a map for each of the three cuts, in one range of colours; of more than 300 x 300 values the means.
/// Throws InputError.
std::string field_cuts_picture(const FieldCutsPicture& picture);

}  // namespace breccia
