#include "campaign/sweep_temperatures.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "breccia/results/stored_responder.hpp"

#include "homogenisation/run/packed_stage.hpp"
#include "results/sweep_spread.hpp"

namespace breccia {
namespace {

bool is_temperature(const SweptKey& key) {
  const auto steps = split_path(key.path);
  constexpr std::size_t depth = 4;
  return steps && steps->size() == depth && steps->at(0) == "materials" && steps->at(2) == "temperature_shift" &&
         steps->at(3) == "temperature";
}

/// Whether reduced responses can give all results that the tests request. Fields at times given in the deck need a run.
bool can_be_answered(const Tests& tests) {
  const bool wants_maps = tests.lists_field_times || tests.field_times.size() > 1 ||
                          (tests.field_times.size() == 1 && tests.field_times.front() != tests.last_time);
  return !wants_maps && tests.methods == std::vector{Method::quasistatic} &&
         tests.quasistatic.solver == Solver::reduced && tests.quasistatic.range == SampledRange::matrix;
}

}  // namespace

std::optional<std::size_t> task_that_answers(const Sweep& sweep, std::size_t task) {
  const auto& asked = sweep.tasks[task];
  if (std::ranges::none_of(sweep.keys, is_temperature) || !can_be_answered(asked.study.tests)) return std::nullopt;
  for (std::size_t earlier = 0; earlier < task; ++earlier) {
    if (differ_only_in(sweep, sweep.tasks[earlier], asked, is_temperature)) return earlier;
  }
  return std::nullopt;
}

std::vector<StageResult> answered_stages(const Study& study, const std::filesystem::path& directory) {
  const auto base = read_responder(directory);
  const auto varying = varying_materials(base.stages());
  std::vector<NewMaterial> materials;
  for (const auto& [material, shift, constants, expansion] : study.materials) {
    if (std::ranges::find(varying, material.name) != varying.end()) {
      materials.push_back({material.name, material, shift});
    }
  }
  auto responded = base.with(materials).within({study.tests.first_time, study.tests.last_time}).respond();
  std::vector<StageResult> results;
  for (const auto& stage : study.stages) {
    auto& by_response = *std::ranges::find(responded, stage.name, &StageResult::name);
    auto& result = results.emplace_back(packed_stage(study, stage, make_microstructure(stage)));
    result.tests = std::move(by_response.tests);
    result.materials = std::move(by_response.materials);
    for (auto& warning : by_response.warnings) {
      if (std::ranges::find(result.warnings, warning) == result.warnings.end()) {
        result.warnings.push_back(std::move(warning));
      }
    }
  }
  return results;
}

}  // namespace breccia
