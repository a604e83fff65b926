#pragma once

#include <vector>

#include "breccia/io/deck.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Reads [[stages]]; their materials must be among the given ones.
std::vector<Stage> read_stages(const Section& deck, const std::vector<Material>& materials);

}  // namespace breccia
