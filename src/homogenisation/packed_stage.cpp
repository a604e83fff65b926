#include "breccia/homogenisation/packed_stage.hpp"

#include <set>
#include <utility>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_warnings.hpp"
#include "breccia/study/test_rules.hpp"

namespace breccia {

StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.dimensions = stage.dimensions;
  result.microstructure = std::move(microstructure);
  result.warnings = warnings_on(study, stage, result.microstructure);
  if (model_of(study.tests, stage) == Model::films) {
    result.point_fraction = result.microstructure.fraction;
    return result;
  }
  const auto discretisation = discretise(stage, result.microstructure, stage.cells, study.tests.mixing);
  const auto phases = phases_of(stage);
  result.points = point_count(stage, stage.cells);
  const auto shares = fractions(discretisation, phases.size());
  std::set<PhaseIndex> of_fillers;
  for (const auto& filler : stage.fillers) of_fillers.insert(phases.index_of(phase_of(stage, filler.material)));
  for (const auto phase : of_fillers) result.point_fraction += shares[phase];
  return result;
}

}  // namespace breccia
