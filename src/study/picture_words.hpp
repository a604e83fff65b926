#pragma once

#include <string>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia {

// What was made of a picture, in words. Empty for a stage that is no image.

/// How a threshold divides the grey values, a line each: the threshold, the two sides, how well they are separated.
/// Empty for a picture of labels, too.
[[nodiscard]] std::vector<std::string> words_on_threshold(const Stage& stage);

/// What the sides of the picture cut, and how well opposite ones fit together; empty without filler, too.
[[nodiscard]] std::string words_on_sides(const Stage& stage);

/// The part of the picture that is used; empty where it is the whole picture.
[[nodiscard]] std::string words_on_crop(const Stage& stage);

/// The name of the material with a label in an image.
[[nodiscard]] std::string material_of_label(const Stage& stage, Label label);

}  // namespace breccia
