#pragma once

#include <cstddef>
#include <filesystem>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The largest number of points for which labels are written, that of 2048 x 2048 cells: larger files would exceed all
/// other results of a study.
inline constexpr std::size_t most_labelled_points = std::size_t{4096} * 4096;

/// Writes the labels of the material points of the finest grid of a stage to its directory. The file `labels.npy` has
/// the numbers of their phases, and a deck can read it as an image; `labels.vti`, for ParaView, has the numbers of the
/// particles or grains, too. Writes nothing for more than most_labelled_points. Throws FileError.
void write_labels(const std::filesystem::path& directory, const Stage& stage,
                  const StageMicrostructure& microstructure);

}  // namespace breccia
