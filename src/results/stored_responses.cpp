#include "results/stored_responses.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/run/comparison.hpp"
#include "results/response_file.hpp"
#include "results/stored_comparisons.hpp"
#include "results/stored_document.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

StageResponses read_stage(const fs::path& file, const std::string& name) {
  auto responses = read_responses(file);
  if (responses.stage == name) return responses;
  throw InputError(fmt::format("{}: the responses are of stage {}, not of one with the name of the directory, {}",
                               file.string(), responses.stage, name));
}

}  // namespace

std::vector<StageResponses> read_stored_responses(const fs::path& directory, const StudyDocument& document) {
  std::vector<StageResponses> all;
  auto comparisons = read_comparisons(directory);
  for (const auto& stage : document.stages) {
    const auto file = directory / stage.name / "response.h5";
    if (!fs::exists(file)) continue;
    auto responses = read_stage(file, stage.name);
    if (responses.deck_hash != document.hash) {
      throw InputError(
          fmt::format("{}: the responses of stage {} are of another study (deck hash {}) than study.json ({})",
                      directory.string(), stage.name, responses.deck_hash, document.hash));
    }
    for (const auto& filler : stage.fillers) responses.fillers.push_back(filler.material);
    responses.warnings = stage.warnings;
    responses.rules = rules_in(stage.quality);
    responses.abscissa = document.frequencies ? Abscissa::frequency : Abscissa::time;
    responses.measurements = measurements_of(stage.name, comparisons[stage.name]);
    if (const auto note = note_on_responses(file)) responses.warnings.push_back(*note);
    if (const auto note = note_on_completeness(directory, document)) responses.warnings.push_back(*note);
    all.push_back(std::move(responses));
  }
  return all;
}

}  // namespace breccia
