#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// The mapping of values to colours. A diverging scale is linear with light grey at zero, and another hue on each side.
enum class ColourScale { linear, logarithmic, diverging };

/// The load of the box of a map, shown by a small picture below it.
enum class DrawnLoad { none, shear, stretch, dilatation };

/// A map of one quantity over a square.
struct FieldPicture {
  std::string title = {};
  std::string quantity = {};        ///< name of the quantity, with the unit of the labels
  double unit_size = 1.0;           ///< unit of the labels in the unit of the values
  std::size_t columns = 0;          ///< number of columns of values, and of rows
  std::vector<double> values = {};  ///< row by row from the lower left corner
  ColourScale scale = ColourScale::linear;
  double side = 0.0;  ///< side of the square [m], for a scale bar; 0 for none
  DrawnLoad load = DrawnLoad::none;
  std::vector<std::uint8_t> phases = {};  ///< phases of the values, whose outlines are drawn; or none
};

/// Maps of one quantity over the middle planes of a cube.
struct FieldCutsPicture {
  std::string title = {};
  std::string quantity = {};  ///< name of the quantity, with the unit of the labels
  double unit_size = 1.0;     ///< unit of the labels in the unit of the values
  std::size_t columns = 0;    ///< number of columns of values of each cut, and of rows
  /// The values on the plane across each axis. The axis that follows it in the cycle x, y, z runs to the right, the one
  /// before it upwards; row by row from the lower left corner.
  std::array<std::vector<double>, 3> cuts = {};
  ColourScale scale = ColourScale::linear;
  double side = 0.0;  ///< side of the cube [m], for a scale bar; 0 for none
};

/// SVG with a map of the values, a colour bar, a scale bar, and the smallest and largest value. The map has at most 600
/// x 600 squares; where there are more values it shows means over equal squares. The colours range from the 1st to the
/// 99th percentile of the map. On a logarithmic scale values that are not positive get the lowest colour. A linear
/// scale whose range has values of both signs is made a diverging one. Throws InputError when the values, or the phases
/// if there are any, do not fill a square, or a value is not finite.
std::string field_picture(const FieldPicture& picture);

/// SVG with a map for each of the three cuts, in one range of colours; each map has at most 300 x 300 squares. Throws
/// the errors of field_picture().
std::string field_cuts_picture(const FieldCutsPicture& picture);

}  // namespace breccia
