#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

#include "virtual_test/quasistatic_test.hpp"

namespace breccia {

/// Gives each particle of a stage that is a crystal a phase of its own in a test of cells; the numbers of these phases
/// follow those of the other phases. In cells that an interface crosses, and where a point of a cell lies outside of
/// the particle that fills the cell, a crystal keeps the isotropic means of its material (theory, section 9). Throws
/// InputError for more crystals than a PhaseIndex can number, and where a list has another number of orientations.
void add_crystals(const Stage& stage, const StageMicrostructure& packed, QuasistaticTest& test);

}  // namespace breccia
