#pragma once

#include <optional>
#include <string>

#include "breccia/microstructure/packing.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// What will pack in the place of what a stage asks for.
struct PackingAdvice {
  std::optional<double> gap;       ///< with the particles asked for, this [m] or less
  std::optional<int> cells;        ///< where the gap follows the grid: so many a side or more
  std::optional<double> fraction;  ///< with the gap asked for, this or less; of a stage with a fraction alone [-]
};

/// Advice on a request of a stage that could not be packed. Rounded to two digits, to the safe side.
PackingAdvice packing_advice(const Stage& stage, const PackingRequest& request, const PackingError& error);

/// The error in the words of the deck, with the fraction and the gap as asked for, and with the advice.
std::string message_on(const Stage& stage, const PackingRequest& request, const PackingError& error);

}  // namespace breccia
