#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// The fractions of the fillers of a stage that follow from their amounts [-], in the order of the fillers: nothing for
/// a filler without `amount`, NaN after a mistake was reported.
using FractionsByAmounts = std::vector<std::optional<double>>;

/// Reads `amount` of all fillers, `{ volume = "7 %" }` or `{ mass = "65 %" }`: the shares of the whole composite, which
/// is that of the last stage of a chain, where each stage is the matrix of the next. The binder, the matrix of the
/// first stage, takes the rest. Returns the fractions that make the boxes of all stages have these shares, in the order
/// of the stages.
std::vector<FractionsByAmounts> read_amounts(std::span<const Section> stages,
                                             const std::vector<ShiftedMaterial>& materials);

/// The fractions that follow from amounts in the first `stages` stages of a study that was read from a deck, as text.
/// They depend on later stages, too.
std::string fractions_by_amounts(const Section& deck, const Study& study, std::size_t stages);

}  // namespace breccia
