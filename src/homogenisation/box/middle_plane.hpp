#pragma once

#include <cstddef>

#include "breccia/homogenisation/box.hpp"
#include "breccia/microstructure/label_image.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

// The phases (phases_of) in the plane through the middle of a box of three dimensions with this normal (0, 1 or 2), as
// an image: the axis that follows the normal (x, y, z, x ...) goes to the right, the next one upwards. It has 500 x 500
// pixels, each with the phase in its centre. Debonded films of grains have the number after those of the
// phases.
[[nodiscard]] LabelImage<2> middle_plane(const Stage& stage, const EllipsoidBox& ellipsoids, std::size_t normal);
[[nodiscard]] LabelImage<2> middle_plane(const Stage& stage, const Grains<3>& grains, std::size_t normal);
[[nodiscard]] LabelImage<2> middle_plane(const Stage& stage, const SharedImage<3>& image, std::size_t normal);

}  // namespace breccia
