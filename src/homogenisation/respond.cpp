#include "breccia/homogenisation/respond.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_materials.hpp"
#include "breccia/homogenisation/stage_warnings.hpp"
#include "breccia/homogenisation/varying_phases.hpp"
#include "breccia/quasistatic/sampled_moduli.hpp"
#include "breccia/study/chain.hpp"
#include "breccia/study/identity.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "coverage_refusal.hpp"
#include "inclusions.hpp"
#include "stage_extrapolation.hpp"

namespace breccia {
namespace {

/// The test of a response whose varying phases are of these materials.
TestResult test_of(const StoredResponses::Entry& entry, const std::vector<Material>& materials,
                   const TimeWindow& window, int points_per_decade) {
  const auto& response = entry.response;
  const auto compliance = creep_compliance(response, materials);
  TestResult test{.id = {response.load, response.boundary, Method::quasistatic, entry.grid},
                  .error_estimate = largest_error(response, materials, window),
                  .seconds = 0.0,
                  .record = QuasistaticRecord{.reduced = response}};
  test.series = relaxation_modulus(compliance);
  for (const double time : logarithmic_times(window, points_per_decade)) {
    test.modulus.push_back({time, test.series.at(time)});
    if (response.boundary == Boundary::traction) test.compliance.push_back({time, compliance.at(time)});
  }
  return test;
}

/// The stage of the responses, with only the members that respond() needs.
Stage stage_of(const StoredResponses& stored) {
  Stage stage;
  stage.name = stored.stage;
  stage.matrix = stored.matrix;
  stage.side = stored.side;
  if (stored.dimensions == 3) stage.packing = PackingMethod<3>();
  std::set<int> grids;  // none with films
  for (const auto& entry : stored.entries) {
    if (const auto cells = entry.grid.cells()) grids.insert(*cells);
  }
  if (!grids.empty()) {
    stage.cells = *grids.rbegin();
    stage.coarser_cells.assign(grids.begin(), std::prev(grids.end()));
  }
  stage.fillers.emplace_back().material.density = stored.filler_density;
  return stage;
}

/// Throws NotCovered if one of the responses of the stage does not cover the whole window.
StageResult respond_within(const StoredResponses& stored, const MatrixUnder& matrix, const TimeWindow& times) {
  if (stored.entries.empty()) throw InputError(fmt::format("stage {} has no reduced response", stored.stage));
  require_coverage(stored, matrix, times);
  StageResult result;
  result.name = stored.stage;
  const auto stage = stage_of(stored);
  result.cells = stage.cells;
  result.dimensions = stage.dimensions();
  result.microstructure.fraction = stored.filler_fraction;
  result.microstructure.fillers = {{.fraction = stored.filler_fraction}};
  for (const auto& entry : stored.entries) {
    const auto materials = materials_for(stored, entry.response, matrix(entry.response.boundary));
    result.tests.push_back(test_of(entry, materials, times, stored.points_per_decade));
  }
  std::ranges::stable_sort(result.tests, {}, [](const TestResult& test) { return test.id.grid; });
  for (auto& test : extrapolate_tests(stage, result.tests, stored.mixing)) result.tests.push_back(std::move(test));
  return result;
}

/// The study of the responses, with only the members that respond() needs.
Study study_of(const std::vector<StoredResponses>& stored, const TimeWindow& times) {
  Study study;
  study.tests.first_time = times.begin;
  study.tests.last_time = times.end;
  study.tests.boundaries.clear();
  for (const auto& one : stored) {
    study.stages.push_back(stage_of(one));
    study.tests.fit_tolerance = one.fit_tolerance;
    study.tests.mixing = one.mixing;
    study.tests.points_per_decade = one.points_per_decade;
    for (const auto& entry : one.entries) {
      auto& boundaries = study.tests.boundaries;
      const auto boundary = entry.response.boundary;
      if (std::ranges::find(boundaries, boundary) == boundaries.end()) boundaries.push_back(boundary);
    }
  }
  return study;
}

InputError without_its_matrix(const StoredResponses& stage) {
  return InputError(fmt::format("stage {}: its matrix is the result of stage {}, of which there is no response",
                                stage.stage, name_of(stage.matrix)));
}

/// The first of the remaining stages whose matrix is a material or a finished stage.
std::vector<StoredResponses>::const_iterator next_stage(const std::vector<StoredResponses>& stored,
                                                        const std::vector<StageResult>& done) {
  const auto is_done = [&done](const std::string& stage) {
    return std::ranges::find(done, stage, &StageResult::name) != done.end();
  };
  const auto next = std::ranges::find_if(stored, [&](const StoredResponses& one) {
    const auto* earlier = std::get_if<EarlierStage>(&one.matrix);
    return !is_done(one.stage) && (earlier == nullptr || is_done(earlier->name));
  });
  if (next != stored.end()) return next;
  const auto& stuck = *std::ranges::find_if(stored, [&](const StoredResponses& one) { return !is_done(one.stage); });
  throw without_its_matrix(stuck);
}

void refuse_several_studies(const std::vector<StoredResponses>& stored) {
  for (const auto& one : stored) {
    if (one.deck_hash == stored.front().deck_hash) continue;
    throw InputError(fmt::format(
        "the responses of stages {} and {} are of different studies (deck hashes {} and {}); name a stage, or run the "
        "study anew in a directory of its own",
        stored.front().stage, one.stage, stored.front().deck_hash, one.deck_hash));
  }
}

void refuse_equal_stages(const std::vector<StoredResponses>& stored) {
  for (auto one = stored.begin(); one != stored.end(); ++one) {
    if (std::find_if(stored.begin(), one, [&](const auto& earlier) { return earlier.stage == one->stage; }) == one) {
      continue;
    }
    throw InputError(
        fmt::format("the responses of stage {} are given twice; give those of each stage once", one->stage));
  }
}

/// Throws InputError if the matrices of the stages are different materials, since one material replaces only one.
void refuse_mixtures(const std::vector<StoredResponses>& stored) {
  const StoredResponses* first = nullptr;
  for (const auto& one : stored) {
    if (!std::holds_alternative<Material>(one.matrix)) continue;
    if (first == nullptr) first = &one;
    if (name_of(one.matrix) == name_of(first->matrix)) continue;
    throw InputError(
        fmt::format("stages {} and {} have different matrices, {} and {}; name the stage that the new "
                    "material is for",
                    first->stage, one.stage, name_of(first->matrix), name_of(one.matrix)));
  }
}

/// Adds a warning to a stage if times are outside the relaxation spectrum of its new matrix.
void warn_of_unknown_times(StageResult& result, const Material& matrix, const TimeWindow& window) {
  const auto warning = warning_of_unknown_times(matrix, window);
  if (warning) result.warnings.push_back(fmt::format("{}: {}", result.name, *warning));
}

const Material& material_named(const std::string& name, const std::map<std::string, Material>& matrices) {
  const auto material = matrices.find(name);
  if (material != matrices.end()) return material->second;
  throw InputError(fmt::format("no new material for \"{}\", which is the matrix of a stage", name));
}

/// The responses of a stage with those of its phases other than the matrix replaced that a new material is given for,
/// by the name of the old one.
StoredResponses with_new_phases(StoredResponses stored, const std::map<std::string, Material>& materials) {
  for (auto& [phase, material] : stored.other_phases) {
    const auto replacement = materials.find(material.name);
    if (replacement != materials.end()) material = replacement->second;
  }
  return stored;
}

/// Computes all stages in the order in which they build on each other, with new materials by the names of the old ones.
std::vector<StageResult> respond_within(const std::vector<StoredResponses>& stored,
                                        const std::map<std::string, Material>& matrices, const TimeWindow& window) {
  const auto study = study_of(stored, window);
  std::vector<StageResult> done;
  while (done.size() < stored.size()) {
    const auto next = with_new_phases(*next_stage(stored, done), matrices);
    auto stage = stage_of(next);
    if (std::holds_alternative<Material>(stage.matrix)) stage.matrix = material_named(name_of(next.matrix), matrices);
    const MatrixUnder matrix_under = [&](Boundary boundary) -> const Material& {
      return matrix_of(stage, done, boundary, Method::quasistatic);
    };
    auto result = respond_within(next, matrix_under, window);
    if (const auto* material = std::get_if<Material>(&stage.matrix)) warn_of_unknown_times(result, *material, window);
    if (serves_as_matrix(study, stage)) result.materials = materials_from(study, stage, done, result);
    done.push_back(std::move(result));
  }
  return done;
}

}  // namespace

StoredResponses responses_of(const Study& study, const Stage& stage, const StageResult& result) {
  if (result.name != stage.name || result.cells != stage.cells) {
    throw InputError(fmt::format("a result of stage {} with {} cells is none of stage {} with {} cells", result.name,
                                 result.cells, stage.name, stage.cells));
  }
  const auto& tests = study.tests;
  const auto inclusions = inclusions_of(stage, result.microstructure.fillers);
  StoredResponses responses = {.stage = stage.name,
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
                               .mixing = tests.mixing,
                               .entries = {}};
  for (const auto& test : result.tests) {
    const auto* record = std::get_if<QuasistaticRecord>(&test.record);
    if (record == nullptr || !record->reduced) continue;
    responses.entries.push_back({test.id.grid, *record->reduced});
  }
  return responses;
}

std::vector<StoredResponses> responses_of(const Study& study, const StudyResult& result) {
  const auto hash = provenance_of(study).hash;
  if (result.study_hash != hash) {
    throw InputError(
        fmt::format("the result is of another study (hash {}) than this one (hash {}), or of this one before "
                    "it was changed",
                    result.study_hash, hash));
  }
  std::vector<StoredResponses> responses;
  for (const auto& done : result.stages) {
    const auto stage = std::ranges::find(study.stages, done.name, &Stage::name);
    if (stage == study.stages.end()) throw InputError(fmt::format("the study has no stage {}", done.name));
    auto of_stage = responses_of(study, *stage, done);
    if (!of_stage.entries.empty()) responses.push_back(std::move(of_stage));
  }
  return responses;
}

StageResult respond(const StoredResponses& stored, const Material& matrix, std::optional<TimeWindow> times) {
  return or_tell_covered_times(times.value_or(stored.times), [&](const TimeWindow& window) {
    auto result = respond_within(
        stored, [&](Boundary) -> const Material& { return matrix; }, window);
    warn_of_unknown_times(result, matrix, window);
    return result;
  });
}

std::vector<StageResult> respond(const std::vector<StoredResponses>& stored, const Material& matrix,
                                 std::optional<TimeWindow> times) {
  refuse_mixtures(stored);
  std::map<std::string, Material> matrices;
  for (const auto& one : stored) {
    if (std::holds_alternative<Material>(one.matrix)) matrices.emplace(name_of(one.matrix), matrix);
  }
  return respond(stored, matrices, times);
}

std::vector<StageResult> respond(const std::vector<StoredResponses>& stored,
                                 const std::map<std::string, Material>& matrices, std::optional<TimeWindow> times) {
  if (stored.empty()) return {};
  refuse_equal_stages(stored);
  refuse_several_studies(stored);
  return or_tell_covered_times(times.value_or(stored.front().times),
                               [&](const TimeWindow& window) { return respond_within(stored, matrices, window); });
}

void require_earlier_stages(const std::vector<StoredResponses>& stored) {
  for (const auto& one : stored) {
    const auto* earlier = std::get_if<EarlierStage>(&one.matrix);
    if (earlier == nullptr || std::ranges::find(stored, earlier->name, &StoredResponses::stage) != stored.end())
      continue;
    throw without_its_matrix(one);
  }
}

}  // namespace breccia
