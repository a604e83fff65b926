#pragma once

#include "breccia/io/deck.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Reports what each part of a study allows and the whole does not.
void refuse_contradictions(const Section& deck, const Study& study);

}  // namespace breccia
