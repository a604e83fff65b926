#pragma once

#include <optional>
#include <vector>

#include "breccia/io/deck.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Reads `filler` and `packing` of a stage whose box and cells have been read; nothing when it has neither.
std::optional<Filler> read_filler(const Section& stage_section, const Stage& stage,
                                  const std::vector<Material>& materials);

}  // namespace breccia
