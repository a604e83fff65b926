#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// Warnings on a stage that is an image: on its threshold, a frame, what its sides cut, and the size of its pixels.
/// Empty for any other stage.
[[nodiscard]] std::vector<std::string> warnings_on_image(const Study& study, const Stage& stage);

}  // namespace breccia
