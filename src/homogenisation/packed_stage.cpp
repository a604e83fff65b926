#include "breccia/homogenisation/packed_stage.hpp"

#include <utility>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_warnings.hpp"

namespace breccia {

StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.microstructure = std::move(microstructure);
  result.warnings = warnings_on(study, stage, result.microstructure);
  const auto discretisation = discretise(stage, result.microstructure.microstructure, stage.cells, study.tests.mixing);
  result.points = discretisation.points();
  if (stage.filler) {
    const auto phases = phases_of(stage);
    result.point_fraction = discretisation.fractions(phases.size())[phases.index_of(name_of_filler_phase)];
  }
  return result;
}

}  // namespace breccia
