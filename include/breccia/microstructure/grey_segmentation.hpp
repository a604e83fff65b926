#pragma once

#include <cstdint>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// The pixels of a grey picture on one side of a threshold.
struct GreySide {
  Label label = 0;             ///< number of their phase
  std::int32_t darkest = 0;    ///< the least of their grey values
  std::int32_t brightest = 0;  ///< the largest of their grey values
  double mean = 0.0;           ///< mean of their grey values
  double share = 0.0;          ///< share of all pixels [-]

  friend bool operator==(const GreySide&, const GreySide&) = default;
};

/// What a threshold makes of a grey picture: pixels above it are bright, all others dark. Grey values are those that
/// the file stores, 0 to 255 in a picture of 8 bits.
struct GreySegmentation {
  double threshold = 0.0;
  bool is_otsu = false;  ///< found by Otsu's method, not given
  int median_side = 1;   ///< side of the squares or cubes of pixels whose median each pixel took first; 1 for none
  GreySide dark = {}, bright = {};
  /// Otsu's measure of separability: the variance between the two sides over that of all pixels [-]. It is 1 for two
  /// grey values alone.
  double separability = 0.0;
  double margin = 0.0;  ///< a tenth of the distance of the two means
  /// Share of the pixels that are bright at a threshold lower, or higher, by the margin [-].
  double bright_at_lower = 0.0, bright_at_higher = 0.0;
  /// Rows, columns or layers at the sides of the picture of one grey value each, as those of a frame: the largest
  /// number at one side.
  std::size_t frame = 0;

  friend bool operator==(const GreySegmentation&, const GreySegmentation&) = default;
};

}  // namespace breccia
