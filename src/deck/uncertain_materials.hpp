#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Lets the reduced responses of a study hold for all moduli that the distributions of its deck give to its materials,
/// up to most_score: adds these materials to those that vary (Tests::varied). Leaves out materials that vary already,
/// and those that cannot vary in this study; each of their moduli takes a run of its own. The study was read from the
/// deck, without a mistake.
void vary_uncertain_materials(const Deck& document, Study& study);

/// The name of the material to which an input belongs; nothing for another part of the deck, and for a density, which
/// changes masses and no modulus.
std::optional<std::string> material_of(const UncertainInput& input);

/// Whether the reduced responses of a study answer the values of an input: it is a number of a material that varies.
bool is_answered_by_responses(const UncertainInput& input, const Study& study);

/// The material of a deck with values of its own for some keys.
ShiftedMaterial material_with(const Deck& document, const std::string& material, const std::vector<Setting>& settings);

}  // namespace breccia
