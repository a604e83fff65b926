#include "homogenisation/respond/responded_stages.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/respond/coverage_refusal.hpp"
#include "homogenisation/run/comparison.hpp"
#include "homogenisation/run/isotropic_mean.hpp"
#include "homogenisation/run/stage_extrapolation.hpp"
#include "homogenisation/stage_materials.hpp"
#include "quasistatic/reduced/sampled_moduli.hpp"
#include "study/chain.hpp"
#include "virtual_test/reduced_curves.hpp"

namespace breccia {
namespace {

/// The test of a response whose varying phases are of these materials.
TestResult test_of(const StageResponses::Entry& entry, const std::vector<Material>& materials, const TimeWindow& window,
                   int points_per_decade) {
  const auto& [grid, reduced] = entry;
  auto response = reduced_curves(reduced, materials, logarithmic_times(window, points_per_decade));
  return {.id = {reduced.load, reduced.boundary, Method::quasistatic, grid},
          .modulus = std::move(response.modulus),
          .compliance = std::move(response.compliance),
          .series = std::move(response.series),
          .error_estimate = largest_error(reduced, materials, window),
          .seconds = 0.0,
          .record = QuasistaticRecord{.reduced = std::move(response.reduced)}};
}

/// The boundaries under which a stage was tested, each once.
std::vector<Boundary> boundaries_of(const StageResponses& stage) {
  std::vector<Boundary> boundaries;
  for (const auto& [grid, response] : stage.entries) {
    if (std::ranges::find(boundaries, response.boundary) == boundaries.end()) boundaries.push_back(response.boundary);
  }
  return boundaries;
}

/// The result of a stage as the matrix of later ones.
std::vector<StageMaterial> materials_of(const StageResponses& stage, const MatrixUnder& matrix,
                                        const TimeWindow& window, const std::vector<TestResult>& tests) {
  const StageFit fit = {.stage = stage.stage,
                        .side = stage.side,
                        .dimensions = stage.dimensions,
                        .mixing = stage.mixing,
                        .shear = stage.shear,
                        .times = window,
                        .points_per_decade = stage.points_per_decade,
                        .tolerance = stage.fit_tolerance};
  std::vector<StageMaterial> materials;
  for (const auto boundary : boundaries_of(stage)) {
    const double density =
        (1.0 - stage.filler_fraction) * matrix(boundary).density + stage.filler_fraction * stage.filler_density;
    materials.push_back(fitted_material(fit, tests, boundary, Method::quasistatic, density));
  }
  return materials;
}

/// Adds the mean of the shears under each boundary and on each grid.
void add_isotropic_means(int dimensions, std::vector<TestResult>& tests) {
  std::vector<TestResult> means;
  for (const auto& test : tests) {
    if (test.id.load == isotropic_shears(dimensions).front())
      means.push_back(isotropic_mean(dimensions, test.id, tests));
  }
  std::ranges::move(means, std::back_inserter(tests));
}

/// The tests of a stage. Throws NotCovered if one of its responses does not cover the whole window.
StageResult tested_stage(const StageResponses& stage, const MatrixUnder& matrix, const TimeWindow& window) {
  if (stage.entries.empty()) throw InputError(fmt::format("stage {} has no reduced response", stage.stage));
  require_coverage(stage, matrix, window);
  StageResult result;
  result.name = stage.stage;
  result.dimensions = stage.dimensions;
  for (const auto& entry : stage.entries) {
    result.cells = std::max(result.cells, entry.grid.cells().value_or(0));
    const auto materials = materials_for(stage, entry.response, matrix(entry.response.boundary));
    result.tests.push_back(test_of(entry, materials, window, stage.points_per_decade));
  }
  if (stage.shear.is_isotropic()) add_isotropic_means(stage.dimensions, result.tests);
  std::ranges::stable_sort(result.tests, {}, [](const TestResult& test) { return test.id.grid; });
  for (auto& test : extrapolate_tests(stage.stage, stage.side, stage.dimensions, result.tests, stage.mixing)) {
    result.tests.push_back(std::move(test));
  }
  return result;
}

InputError without_its_matrix(const StageResponses& stage) {
  return InputError(fmt::format("stage {}: its matrix is the result of stage {}, of which there is no response",
                                stage.stage, name_of(stage.matrix)));
}

/// The first of the remaining stages whose matrix is a material or a finished stage.
const StageResponses& next_stage(const std::vector<StageResponses>& stages, const std::vector<StageResult>& done) {
  const auto is_done = [&done](const std::string& stage) {
    return std::ranges::find(done, stage, &StageResult::name) != done.end();
  };
  const auto next = std::ranges::find_if(stages, [&](const StageResponses& one) {
    const auto* earlier = std::get_if<EarlierStage>(&one.matrix);
    return !is_done(one.stage) && (earlier == nullptr || is_done(earlier->name));
  });
  if (next != stages.end()) return *next;
  throw without_its_matrix(
      *std::ranges::find_if(stages, [&](const StageResponses& one) { return !is_done(one.stage); }));
}

}  // namespace

void require_earlier_stages(const std::vector<StageResponses>& stages) {
  for (const auto& one : stages) {
    const auto* earlier = std::get_if<EarlierStage>(&one.matrix);
    if (earlier == nullptr || std::ranges::find(stages, earlier->name, &StageResponses::stage) != stages.end())
      continue;
    throw without_its_matrix(one);
  }
}

std::vector<StageResult> responded_stages(const std::vector<StageResponses>& stages, const TimeWindow& times) {
  std::vector<StageResult> done;
  while (done.size() < stages.size()) {
    const auto& next = next_stage(stages, done);
    const MatrixUnder matrix = [&](Boundary boundary) -> const Material& {
      return matrix_of(next.stage, next.matrix, done, boundary, Method::quasistatic);
    };
    auto result = tested_stage(next, matrix, times);
    add_errors(result, next.rules, next.matrix, done);
    if (next.abscissa == Abscissa::frequency) add_complex_moduli(result.tests, next.points_per_decade);
    result.comparisons = compare(next.measurements, result, next.shear);
    if (serves_as_matrix(stages, next.stage)) result.materials = materials_of(next, matrix, times, result.tests);
    done.push_back(std::move(result));
  }
  return done;
}

}  // namespace breccia
