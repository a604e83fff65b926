#pragma once

#include <optional>

#include "breccia/study/stage.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `shape` of a filler of a stage whose packing has been read: `{ aspect = 1.5, angle = "30 deg" }` or
/// `{ polygon = "file.csv" }`; in three dimensions `{ aspect = 1.5 }` alone, ellipsoids of revolution. Nothing for
/// discs or spheres (an aspect of 1). Reports a shape that the packing cannot place.
std::optional<FillerShape> read_shape(const Section& filler, const Stage& stage);

}  // namespace breccia
