#pragma once

#include "breccia/io/deck.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Reports settings that are valid by themselves but contradict each other.
void refuse_contradictions(const Section& deck, const Study& study);

}  // namespace breccia
