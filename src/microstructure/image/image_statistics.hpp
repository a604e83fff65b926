#pragma once

#include <cstddef>
#include <vector>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

// Instantiated for 2 and 3 dimensions.

/// Share of the pixels that each of the labels 0 .. count - 1 has [-]. Throws InputError when a pixel has another
/// label.
template <int dim>
[[nodiscard]] std::vector<double> label_fractions(const LabelImage<dim>& image, std::size_t count);

/// Length of the sides between pixels of different labels per area of the box, S/A [1/m], with those across the sides
/// of a periodic box; in three dimensions the area of the faces between voxels per volume. The sides of pixels form
/// steps, which are 4/pi times as long as a smooth interface of all directions, however fine the pixels are, and 3/2
/// times as large in three dimensions.
template <int dim>
[[nodiscard]] double specific_interface(const LabelImage<dim>& image);

}  // namespace breccia
