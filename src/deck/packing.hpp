#pragma once

#include <cstddef>
#include <optional>

#include "breccia/io/deck.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Message about a key for particles that are not discs.
inline constexpr auto discs_alone =
    "particles are discs, or grains of a tessellation (\"laguerre\"), or pixels of an image (\"image\"): other shapes "
    "are not available (docs/limitations.md)";

/// Message about an image in the wrong place of a deck.
inline constexpr auto image_elsewhere =
    "an image is a packing without a filler: packing = { method = \"image\", file = \"...\", pixel = \"...\", labels = "
    "[{ value = ..., material = \"...\" }, ...] } (docs/decks.md)";

/// Reads `packing` of a stage with a box of the given side [m] and so many fillers.
std::optional<PackingMethod> read_packing(const Section& stage, double side, std::size_t fillers);

/// Throws InputError where listed particles of a stage, with their coatings, overlap or cross a wall.
void require_room(const Stage& stage, const ExplicitPacking& listed);

/// Whether a packing is random, so that it has a `seed`.
bool takes_seed(const Section& packing);

}  // namespace breccia
