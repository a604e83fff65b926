#pragma once

#include <vector>

#include "breccia/study/measurement.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads [[measurements]] of the stages given.
std::vector<Measurement> read_measurements(const Section& deck, const std::vector<Stage>& stages, const Tests& tests);

}  // namespace breccia
