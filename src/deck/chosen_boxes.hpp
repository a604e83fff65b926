#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "breccia/study/study.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `tests.budget`, the processor time that a run may take with boxes and grids that are chosen for it [s].
std::optional<double> read_budget(const Section& deck, const Study& study);

/// Chooses the boxes and the grids that the stages of a deck without mistakes leave out, for `tests.accuracy` (3 %
/// where the deck does not name it) within the budget (choose_boxes). Warns of what is not reached, and reports
/// particles that jam.
void choose_missing_boxes(const Section& deck, std::optional<double> budget, Study& study);

/// The boxes and grids that the first stages of a deck leave out, in words that differ where another version chooses
/// others.
std::string chosen_boxes(const Section& deck, const Study& study, std::size_t stages);

}  // namespace breccia
