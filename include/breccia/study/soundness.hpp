#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// Checks a study that was put together in memory by the same rules as a deck: names; materials and their temperature
/// shifts; boxes, grids and matrices of the stages; fillers, with the settings that their packing needs; times, lists
/// and options of the tests, and whether the methods can be used on these stages; measurements. Throws InputError with
/// one line for every mistake.
void require_sound(const Study& study);

}  // namespace breccia
