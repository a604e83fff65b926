#include "results/stored_responses.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/response_file.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The names of the stages that have left responses, in alphabetical order.
std::vector<std::string> stages_with_response(const fs::path& directory) {
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (fs::exists(entry.path() / "response.h5")) stages.push_back(entry.path().filename().string());
  }
  std::ranges::sort(stages);
  return stages;
}

StageResponses read_stage(const fs::path& directory, const std::string& name) {
  const auto file = directory / name / "response.h5";
  auto responses = read_responses(file);
  if (responses.stage == name) return responses;
  throw InputError(
      fmt::format("{}: the responses are of stage {}, not of one with the name of the directory, {}; move the copy "
                  "out of {}",
                  file.string(), responses.stage, name, directory.string()));
}

/// Adds to the responses of a stage the parts of its record that a response file does not have.
void add_record(const StudyDocument& document, StageResponses& responses) {
  const auto entry = std::ranges::find(document.stages, responses.stage, &StageEntry::name);
  if (entry == document.stages.end()) return;
  for (const auto& filler : entry->fillers) responses.fillers.push_back(filler.material);
  responses.warnings = entry->warnings;
}

}  // namespace

std::vector<StageResponses> read_stored_responses(const fs::path& directory, const StudyDocument& document) {
  std::vector<StageResponses> all;
  for (const auto& name : stages_with_response(directory)) {
    auto responses = read_stage(directory, name);
    if (responses.deck_hash != document.hash) {
      throw InputError(
          fmt::format("{}: the responses of stage {} are of another study (deck hash {}) than study.json ({})",
                      directory.string(), name, responses.deck_hash, document.hash));
    }
    add_record(document, responses);
    const auto note = note_on_responses(directory / name / "response.h5");
    if (note) responses.warnings.push_back(*note);
    all.push_back(std::move(responses));
  }
  return all;
}

}  // namespace breccia
