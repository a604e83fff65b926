#pragma once

#include <string>
#include <vector>

#include "breccia/assessment/compare_curves.hpp"

#include "deckfile/deck_differences.hpp"

namespace breccia::cli {

/// The sign of a ratio that differs from 1 by no more than its error.
inline constexpr auto within_errors = "(=)";

/// The letter by which tables name a result: "A" for the first.
std::string letter_of(std::size_t result);

/// The values in which decks differ, a line each.
std::string table_of_decks(const std::vector<DeckDifference>& differences);

/// Whether a ratio of a curve to the first has no error.
bool lacks_errors(const ComparedCurve& curve);

/// A curve of several results at whole decades, and how each differs from the first.
std::string table_of_compared(const ComparedCurve& curve);

}  // namespace breccia::cli
