#pragma once

#include <filesystem>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Writes the particles (`microstructure.csv`) or grains (`grains.csv`) of a stage (an image has neither), a picture
/// (`microstructure.svg`), and the labels of its points (write_labels) to its directory. Throws FileError.
void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure);

}  // namespace breccia
