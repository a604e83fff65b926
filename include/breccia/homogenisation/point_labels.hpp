#pragma once

#include <cstdint>
#include <vector>

#include "breccia/discretisation/phase.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The phases and particles at the material points of a stage, in the order of Grid::point_index: x runs fastest, then
/// y upwards, then z.
struct PointLabels {
  std::vector<PhaseIndex> phases;  ///< phase of each point, by the numbers of phases_of(stage)
  /// Number of the particle (with its coating) or of the grain at each point, from 0; -1 in the matrix. Empty for an
  /// image, whose pixels do not distinguish particles.
  std::vector<std::int32_t> particles;
};

/// The labels of the points of a grid of `cells` cells along each side of the box. Each point has the phase at its
/// position (Mixing::points), independently of the mixing in the tests.
PointLabels point_labels(const Stage& stage, const StageMicrostructure& packed, int cells);

}  // namespace breccia
