#pragma once

#include <cstddef>
#include <vector>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// Share of the pixels that each of the labels 0 .. count - 1 has [-]. Throws InputError when a pixel has another
/// label.
[[nodiscard]] std::vector<double> label_fractions(const LabelImage<2>& image, std::size_t count);

/// Length of the sides between pixels of different labels per area of the box, S/A [1/m], with those across the sides
/// of a periodic box. The sides of pixels are a staircase: it is 4/pi times as long as a smooth interface of all
/// directions, however fine the pixels.
[[nodiscard]] double specific_interface(const LabelImage<2>& image);

}  // namespace breccia
