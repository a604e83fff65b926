#pragma once

#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/microstructure/microstructure.hpp"
#include "breccia/study/tests.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// What [tests] says about the stages, which are read before it, and what these say about the tests.
struct StageDefaults {
  Model model = Model::cells;
  /// Walls of random packings and images that do not name theirs: a box is periodic, unless the tests name boundaries
  /// that would cut its particles alone, without the periodic one, or name none and another stage asks for walls.
  Walls walls = Walls::periodic;
  /// Both boundaries of a window where a stage asks for one; else empty, and they follow from the boxes.
  std::vector<Boundary> boundaries = {};
};

StageDefaults read_stage_defaults(const Section& deck);

}  // namespace breccia
