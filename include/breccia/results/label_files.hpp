#pragma once

#include <cstddef>
#include <filesystem>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Labels are written for at most so many points, those of 2048 x 2048 cells: the files of more would be larger than
/// all other results of a study.
inline constexpr std::size_t most_labelled_points = std::size_t{4096} * 4096;

/// Writes what is at the material points of the finest grid of a stage to its directory: `labels.npy`, the numbers of
/// their phases, which an image of a deck reads back, and `labels.vti` for ParaView, with those of the particles or
/// grains, too. Writes nothing for more than most_labelled_points. Throws FileError.
void write_labels(const std::filesystem::path& directory, const Stage& stage,
                  const StageMicrostructure& microstructure);

}  // namespace breccia
