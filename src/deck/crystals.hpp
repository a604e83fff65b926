#pragma once

#include <cstddef>
#include <optional>

#include "breccia/study/crystal.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `stiffness = { symmetry = "monoclinic", C11 = "18.4 GPa", ... }` of a material; nothing after a mistake.
[[nodiscard]] std::optional<ElasticConstants> read_stiffness(const Section& material);

/// Reads `orientations` of a filler, whose number is given and whose particles are crystals: "random", "aligned",
/// { seed = 3 }, or the name of a file of Bunge's Euler angles. A file with a column `filler` has those of several.
[[nodiscard]] Orientations read_orientations(const Section& filler, std::size_t number);

}  // namespace breccia
