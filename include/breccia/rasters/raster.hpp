#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace breccia {

/// What the values of a picture say about the brightness of its pixels.
enum class Shades {
  rising,   ///< 0 is the darkest one
  falling,  ///< 0 is white, as in some TIFF files
  palette   ///< nothing: they are numbers of the colours of a palette
};

/// The content of an image file: whole numbers on a regular lattice of square pixels or of cubic voxels.
///
/// The axes are those of a box: x to the right, y upwards, z from layer to layer. The order of the rows of a file is:
/// - In a picture (PNG, TIFF) and in an array (NumPy, HDF5) the first row is the top one, so that the box looks like
///   the picture in any viewer, and like the array in matplotlib's imshow. Arrays are indexed [y][x] or [z][y][x].
/// - The pages of a TIFF stack, and the first index of an array of three, are layers with z rising.
/// - A VTK ImageData has coordinates of its own: its y and z rise with their index.
/// A file of three dimensions with one layer is read as an image of two dimensions.
struct Raster {
  std::vector<std::size_t> extents;  ///< number of pixels along x, y and, in three dimensions, z
  std::vector<std::int32_t> values;  ///< x runs fastest, then y from the bottom row up, then z
  std::optional<double> pixel;       ///< side of a pixel [m], where the file gives it in a unit of length
  Shades shades = Shades::rising;
};

}  // namespace breccia
