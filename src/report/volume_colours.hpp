#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/field_picture.hpp"

namespace breccia {

/// The values of a volume as numbers of colours, from 0 to 255.
struct VolumeColours {
  double from = 0.0;  ///< the value of the lowest colour
  double to = 0.0;    ///< the value of the highest colour
  std::vector<std::uint8_t> colours;
};

/// The colours of values as in a picture of a field: they range from the 1st to the 99th percentile. Throws InputError
/// when there are no values, or one is not finite.
VolumeColours volume_colours(ColourScale scale, const std::vector<double>& values);

/// The 256 colours of the pictures of fields, six hexadecimal digits each, from the lowest to the highest.
std::string colours_of_fields();

}  // namespace breccia
