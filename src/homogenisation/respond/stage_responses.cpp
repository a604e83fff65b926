#include "breccia/homogenisation/stage_responses.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/inclusions.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/varying_phases.hpp"
#include "study/chain.hpp"
#include "study/identity.hpp"

namespace breccia {

StageResponses responses_of(const Study& study, const Stage& stage, const StageResult& result) {
  if (result.name != stage.name || result.cells != stage.cells) {
    throw InputError(fmt::format("a result of stage {} with {} cells is none of stage {} with {} cells", result.name,
                                 result.cells, stage.name, stage.cells));
  }
  const auto& tests = study.tests;
  const auto inclusions = inclusions_of(stage, result.microstructure.fillers);
  StageResponses responses = {.stage = stage.name,
                              .matrix = stage.matrix,
                              .other_phases = other_varying_phases(tests, stage),
                              .filler_density = mean_density(inclusions),
                              .filler_fraction = fraction_of(inclusions),
                              .side = stage.side,
                              .dimensions = stage.dimensions(),
                              .deck_hash = provenance_of(study).hash,
                              .fit_tolerance = tests.fit_tolerance,
                              .times = {tests.first_time, tests.last_time},
                              .points_per_decade = tests.points_per_decade,
                              .range = tests.quasistatic.range,
                              .mixing = mixing_of(study, stage, result.microstructure),
                              .shear = shear_of_material(tests),
                              .abscissa = tests.abscissa(),
                              .measurements = {},
                              .fillers = {},
                              .warnings = result.warnings,
                              .rules = result.accuracy.rules,
                              .entries = {}};
  for (const auto& measurement : study.measurements) {
    if (measurement.stage == stage.name) responses.measurements.push_back(measurement);
  }
  for (const auto& filler : stage.fillers) responses.fillers.push_back(filler.material.name);
  for (const auto& test : result.tests) {
    const auto* record = std::get_if<QuasistaticRecord>(&test.record);
    if (record == nullptr || !record->reduced) continue;
    responses.entries.push_back({test.id.grid, *record->reduced});
  }
  return responses;
}

std::vector<StageResponses> responses_of(const Study& study, const StudyResult& result) {
  const auto hash = provenance_of(study).hash;
  if (result.study_hash != hash) {
    throw InputError(
        fmt::format("the result is of another study (hash {}) than this one (hash {}), or of this one before "
                    "it was changed",
                    result.study_hash, hash));
  }
  std::vector<StageResponses> responses;
  for (const auto& done : result.stages) {
    const auto stage = std::ranges::find(study.stages, done.name, &Stage::name);
    if (stage == study.stages.end()) throw InputError(fmt::format("the study has no stage {}", done.name));
    auto of_stage = responses_of(study, *stage, done);
    if (!of_stage.entries.empty()) responses.push_back(std::move(of_stage));
  }
  return responses;
}

std::vector<std::string> varying_materials(const std::vector<StageResponses>& stages) {
  std::vector<std::string> names;
  for (const auto& stage : stages) {
    if (std::holds_alternative<Material>(stage.matrix)) names.push_back(name_of(stage.matrix));
    for (const auto& [phase, material] : stage.other_phases) names.push_back(material.name);
  }
  return names;
}

}  // namespace breccia
