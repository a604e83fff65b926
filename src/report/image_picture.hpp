#pragma once

#include <span>
#include <string>
#include <string_view>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// SVG picture of a square image of labels: the box, y upwards, with a scale bar. `colours` holds for each label the
/// number of its colour (colour_of_phase), or 0 for the colour of the matrix. The picture has at most 1000 x 1000
/// pixels. A larger image is shown as equal squares, each in the most frequent colour of its pixels. Throws InputError
/// when the image is not valid or not square, or a label has no colour.
std::string image_picture(const LabelImage<2>& image, std::span<const std::size_t> colours);

/// SVG picture of a plane through a microstructure of three dimensions. `colours` holds for each label its colour, such
/// as
/// "#5b7f95"; `content` is the subject in the title of the picture.
std::string plane_picture(const LabelImage<2>& plane, std::span<const std::string_view> colours,
                          std::string_view content);

}  // namespace breccia
