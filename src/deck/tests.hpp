#pragma once

#include <vector>

#include "breccia/io/deck.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"

namespace breccia {

/// Reads [tests]; the stages have been read before.
Tests read_tests(const Section& deck, const std::vector<Stage>& stages);

}  // namespace breccia
