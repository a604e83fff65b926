#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/microstructure/packing.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Settings with which a stage can be packed, in place of the requested ones.
struct PackingAdvice {
  std::optional<double> gap;       ///< largest gap for the requested particles [m]
  std::optional<int> cells;        ///< fewest cells per side, if the gap depends on the grid
  std::optional<double> fraction;  ///< largest fraction for the requested gap, if the stage has a fraction [-]
  /// The largest gaps of several fillers, in their order and in proportion to those requested [m]; empty for one
  /// filler, and where gaps are not the cause.
  std::vector<double> gaps = {};
};

/// Advice on a packing request that failed; numbers are rounded to two digits, to the safe side.
/// Templates are instantiated for 2 and 3 dimensions.
template <int dim>
PackingAdvice packing_advice(const Stage& stage, const PackingRequest& request, const PackingError& error);

/// The message of the error in the terms of the deck, with the requested fraction and gap, and with the advice.
template <int dim>
std::string message_on(const Stage& stage, const PackingRequest& request, const PackingError& error);

}  // namespace breccia
