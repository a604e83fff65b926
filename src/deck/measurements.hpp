#pragma once

#include <vector>

#include "breccia/study/measurement.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads [[measurements]] of the stages given. A remark is made on a measurement at another temperature than that of a
/// material.
std::vector<Measurement> read_measurements(const Section& deck, const std::vector<ShiftedMaterial>& materials,
                                           const std::vector<Stage>& stages, const Tests& tests);

}  // namespace breccia
