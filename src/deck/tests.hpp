#pragma once

#include <optional>
#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"

#include "deck/stage_defaults.hpp"
#include "deckfile/deck.hpp"

namespace breccia {

/// Tolerance of the sampling for studies that need no finer one. With two parameters or more a basis takes many times
/// the snapshots of one parameter, and these moduli are not known well. The model of films has a far larger error, and
/// in boxes with many grains of all sizes rounding errors are not far below the default tolerance.
inline constexpr double coarse_tolerance = 1e-4;

/// Reads tests.mixing, whose default depends on the whole study: nothing where the deck does not have it.
std::optional<Mixing> read_mixing(const Section& deck);

/// Reads the rest of [tests]; the stages have been read before.
Tests read_tests(const Section& deck, const std::vector<Stage>& stages, const StageDefaults& defaults);

}  // namespace breccia
