#pragma once

#include <cstdint>
#include <vector>

#include "breccia/discretisation/phase.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// What is at the material points of a stage, in the order of Grid::point_index: x runs fastest, then y upwards, then
/// z.
struct PointLabels {
  std::vector<PhaseIndex> phases;  ///< by the numbers of phases_of(stage)
  /// The particle with its coating, or the grain, counted from 0; -1 in the matrix. Empty for an image, whose pixels do
  /// not tell one particle from another.
  std::vector<std::int32_t> particles;
};

/// The points on `cells` cells along each side of the box. Each has the phase at its place (Mixing::points), whatever
/// mixing the tests have.
PointLabels point_labels(const Stage& stage, const StageMicrostructure& packed, int cells);

}  // namespace breccia
