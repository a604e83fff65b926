#include "breccia/homogenisation/packed_stage.hpp"

#include <utility>

#include "breccia/homogenisation/stage_warnings.hpp"
#include "breccia/study/phases.hpp"

namespace breccia {

StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.microstructure = std::move(microstructure);
  result.warnings = warnings_on(study, stage, result.microstructure);
  const auto discretisation = discretise(result.microstructure.microstructure, stage.cells, matrix_phase, filler_phase);
  result.points = discretisation.points();
  result.point_fraction = discretisation.fractions(2)[1];
  return result;
}

}  // namespace breccia
