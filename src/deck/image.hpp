#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Whether the microstructure of a stage is an image.
bool has_image(const Section& stage);

/// Reads `packing` and `box` of a stage whose microstructure is an image and whose matrix is known: the image, the side
/// of the box, and the fillers, one for each material of the labels other than the matrix. An image that does not say
/// whether it is periodic has these walls.
void read_image(const Section& section, const std::vector<ShiftedMaterial>& materials, Walls walls, Stage& stage);

/// The cells per side of a stage that give each pixel of its image one material point. Reports an image for which there
/// is no such number.
int cells_of_points(const Section& section, const Stage& stage);

}  // namespace breccia
