#pragma once

#include <span>
#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia {

/// The text of a deck in which a material (`materials.NAME`) or a stage (`stages.INDEX`) has another name, there and
/// wherever the deck names it: as a matrix, the material of a filler, a coating or a label, a material that varies, the
/// stage of a measurement, and in the keys and values of a sweep. All else stays as it is. Throws InputError when the
/// path leads to no material or stage, or when the name is empty or that of another material or stage.
std::string deck_with_name(const std::string& text, std::span<const DeckStep> path, const std::string& name);

/// The text of a deck in which two materials or two stages have changed places. Throws InputError for other paths, for
/// those that deck_with_exchange() refuses, and for stages which the sweep of the deck counts.
std::string deck_with_order(const std::string& text, std::span<const DeckStep> one, std::span<const DeckStep> other);

}  // namespace breccia
