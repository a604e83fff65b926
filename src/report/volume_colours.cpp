#include "report/volume_colours.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "report/colour_map.hpp"
#include "report/colour_range.hpp"

namespace breccia {

VolumeColours volume_colours(ColourScale scale, const std::vector<double>& values) {
  if (values.empty() || !std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    throw InputError("volume of a field: no values, or one that is not finite");
  }
  const ColourRange range(scale, values);
  VolumeColours volume{.from = range.value_at(0.0), .to = range.value_at(1.0), .colours = {}};
  volume.colours.reserve(values.size());
  for (const double value : values) volume.colours.push_back(range.index_of(value));
  return volume;
}

std::string colours_of_fields() {
  std::string text;
  for (const auto& [red, green, blue] : perceptual_colours())
    text += fmt::format("{:02x}{:02x}{:02x}", red, green, blue);
  return text;
}

}  // namespace breccia
