#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// Checks a study that was put together in memory for what the deck reader would have refused: stages without a name, a
/// size or cells, a matrix that is no earlier stage, a filler without the sizes or the fraction that its packing takes,
/// times that do not rise, tests without loads, boundaries or methods. Throws InputError with one line for every
/// mistake.
void require_sound(const Study& study);

}  // namespace breccia
