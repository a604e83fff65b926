#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// Fills a box with discs in columns and rows.
PlacedBox<2> placed(const Stage& stage, const RegularPacking& array, PackingRunner& runner);

/// Fills a box with spheres on a cubic lattice.
PlacedBox<3> placed(const Stage& stage, const LatticePacking& cubic, PackingRunner& runner);

}  // namespace breccia
