#pragma once

#include <cstddef>
#include <optional>

#include "breccia/study/stage.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Message about a shape in place of a packing method.
inline constexpr auto shapes_elsewhere =
    "ellipses and polygons are the shape of a filler, shape = { aspect = 1.5 } with packing.method = "
    "\"random-sequential\", or listed for \"explicit\" (docs/decks.md)";

/// Message about an image in the wrong place of a deck.
inline constexpr auto image_elsewhere =
    "an image is a packing without a filler: packing = { method = \"image\", file = \"...\", pixel = \"...\", labels = "
    "[{ value = ..., material = \"...\" }, ...] } (docs/decks.md)";

/// Reads `packing` of a stage whose box and number of fillers are known, from its section. `walls` are those of a
/// random packing that does not name its own.
std::optional<StagePacking> read_packing(const Section& section, const Stage& stage, std::size_t fillers, Walls walls);

/// Whether a packing has this method.
bool has_method(const Section& packing, PackingName name);

/// Whether a packing is random, so that it has a `seed`.
bool takes_seed(const Section& packing);

}  // namespace breccia
