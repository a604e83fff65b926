#pragma once

#include "breccia/discretisation/crystals.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The cells of a stage for the quasi-static method, with the phases of its crystals. The numbers of these phases
/// follow those of the other phases.
struct StageCells {
  StageDiscretisation discretisation;
  Crystals crystals = {};
};

/// Gives each particle of a stage that is a crystal a phase of its own. The points of mixed cells, and those outside of
/// the particle in a cell that it fills all but for rounding, keep the phase of the filler, whose material has the
/// isotropic means of the crystals. Throws InputError for more phases than a PhaseIndex can number, and where a list
/// has another number of orientations.
[[nodiscard]] StageCells cells_of(const Stage& stage, const StageMicrostructure& packed,
                                  StageDiscretisation discretisation);

}  // namespace breccia
