#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// The unit of the lengths in a file of geometry.
enum class LengthUnit { metre, millimetre, micrometre };
template <>
inline constexpr auto words<LengthUnit> = std::to_array<Word<LengthUnit>>({{"m", LengthUnit::metre},
                                                                           {"mm", LengthUnit::millimetre},
                                                                           {"um", LengthUnit::micrometre}});

/// The number of units in a metre.
constexpr double units_per_metre(LengthUnit unit) {
  return unit == LengthUnit::metre ? 1.0 : unit == LengthUnit::millimetre ? 1e3 : 1e6;
}

}  // namespace breccia
