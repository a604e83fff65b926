#include "homogenisation/run/packed_stage.hpp"

#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "discretisation/joined_discretisation.hpp"
#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/box/fillers_of_particles.hpp"
#include "homogenisation/stage_warnings.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Number of material points of each phase of the fillers in some layers of cells. The points of mixed cells count by
/// the fractions of their phases.
std::vector<double> filler_points(const Study& study, const Stage& stage, const StageMicrostructure& microstructure,
                                  const CellLayers& layers) {
  const auto phases = phases_of(stage);
  const auto by_phase = std::visit([&](const auto& part) { return part.points_by_phase(phases.size()); },
                                   discretise(stage, microstructure, stage.cells, study.tests.mixing, layers));
  std::set<PhaseIndex> of_fillers;
  for (const auto& filler : stage.fillers) of_fillers.insert(phases.index_of(phase_of(stage, filler.material)));
  std::vector<double> points;
  points.reserve(of_fillers.size());
  for (const auto phase : of_fillers) points.push_back(by_phase[phase]);
  return points;
}

/// The result of a stage without the numbers of its points, which grains and films do not have.
StageResult result_without_points(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  StageResult result;
  result.name = stage.name;
  result.cells = stage.cells;
  result.dimensions = stage.dimensions();
  result.microstructure = std::move(microstructure);
  // A list must have the orientations of all crystals.
  static_cast<void>(orientations_of_particles(stage, fillers_of_particles(result.microstructure)));
  result.warnings = warnings_on(study, stage, result.microstructure);
  result.point_fraction = result.microstructure.fraction;
  return result;
}

void set_points(const Stage& stage, const std::vector<double>& of_fillers, StageResult& result) {
  result.points = point_count(stage, stage.cells);
  result.point_fraction = 0.0;
  for (const double points : of_fillers) result.point_fraction += points / static_cast<double>(result.points);
}

}  // namespace

StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  auto result = result_without_points(study, stage, std::move(microstructure));
  if (model_of(study.tests, stage) == Model::films) return result;
  set_points(stage, filler_points(study, stage, result.microstructure, {}), result);
  return result;
}

StageResult packed_stage_together(const Study& study, const Stage& stage, StageMicrostructure microstructure) {
  auto result = result_without_points(study, stage, std::move(microstructure));
  if (model_of(study.tests, stage) == Model::films) return result;
  if (parallel::is_under_mpirun()) parallel::start();
  const auto layers = layers_of_part(stage.cells, parallel::rank(), parallel::ranks());
  auto points = parallel::made_by_all([&] { return filler_points(study, stage, result.microstructure, layers); });
  for (double& of_phase : points) of_phase = parallel::sum(of_phase);
  set_points(stage, points, result);
  return result;
}

}  // namespace breccia
