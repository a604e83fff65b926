#include "breccia/results/stored_responder.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/response_file.hpp"
#include "results/stored_materials.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The names of the stages that have reduced responses, in alphabetical order.
std::vector<std::string> stages_with_response(const fs::path& directory) {
  if (!fs::is_directory(directory)) throw InputError(fmt::format("{}: no such directory", directory.string()));
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (fs::exists(entry.path() / "response.h5")) stages.push_back(entry.path().filename().string());
  }
  std::ranges::sort(stages);
  if (!stages.empty()) return stages;
  throw InputError(fmt::format(
      "{}: no stage with a response.h5, which `breccia run` leaves for tests by the quasi-static method with "
      "the reduced solver",
      directory.string()));
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

}  // namespace

Responder read_responder(const fs::path& directory) {
  std::vector<StageResponses> stages;
  for (const auto& name : stages_with_response(directory)) stages.push_back(read_stage(directory, name));
  const auto study = read_stored_materials(directory);
  for (auto& stage : stages) {
    if (stage.deck_hash != study.deck_hash) {
      throw InputError(
          fmt::format("{}: the responses of stage {} are of another study (deck hash {}) than study.json ({})",
                      directory.string(), stage.stage, stage.deck_hash, study.deck_hash));
    }
    const auto warnings = study.warnings.find(stage.stage);
    if (warnings != study.warnings.end()) stage.warnings = warnings->second;
    const auto note = note_on_responses(directory / stage.stage / "response.h5");
    if (note) stage.warnings.push_back(*note);
  }
  return Responder(std::move(stages), study.materials);
}

}  // namespace breccia
