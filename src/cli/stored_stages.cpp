#include "stored_stages.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/results/response_file.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

/// The names of the stages that have reduced responses, in alphabetical order.
std::vector<std::string> stages_with_response(const fs::path& results) {
  if (!fs::is_directory(results)) throw InputError(fmt::format("{}: no such directory", results.string()));
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(results)) {
    if (fs::exists(entry.path() / "response.h5")) stages.push_back(entry.path().filename().string());
  }
  std::ranges::sort(stages);
  if (!stages.empty()) return stages;
  throw InputError(fmt::format(
      "{}: no stage with a response.h5, which `breccia run` leaves for tests by the quasi-static method with "
      "the reduced solver",
      results.string()));
}

std::vector<std::string> chosen_stages(const fs::path& results, const std::string& stage) {
  auto stages = stages_with_response(results);
  if (stage.empty()) return stages;
  if (std::ranges::find(stages, stage) != stages.end()) return {stage};
  throw InputError(
      fmt::format("{}: no response of a stage \"{}\"{}", results.string(), stage, suggestion(stage, stages)));
}

}  // namespace

std::vector<StoredResponses> responses_of_stage(const fs::path& results, const std::string& stage) {
  std::vector<StoredResponses> stored;
  for (const auto& name : chosen_stages(results, stage)) {
    const auto file = results / name / "response.h5";
    stored.push_back(read_responses(file));
    if (const auto note = note_on_responses(file)) fmt::print(stderr, "note: {}\n", *note);
    if (stored.back().stage == name) continue;
    throw InputError(
        fmt::format("{}: the responses are of stage {}, not of one with the name of the directory, {}; move the copy "
                    "out of {}",
                    file.string(), stored.back().stage, name, results.string()));
  }
  return stored;
}

std::vector<StoredResponses> responses_of_chain(const fs::path& results, const std::string& stage) {
  static_cast<void>(chosen_stages(results, stage));
  auto stored = responses_of_stage(results, "");
  if (stage.empty()) return stored;
  std::vector<StoredResponses> chain;
  for (auto wanted = stage; chain.size() < stored.size();) {
    const auto found = std::ranges::find(stored, wanted, &StoredResponses::stage);
    if (found == stored.end()) break;
    chain.push_back(*found);
    if (std::holds_alternative<Material>(found->matrix)) break;
    wanted = name_of(found->matrix);
  }
  return chain;
}

std::vector<StoredMaterial> materials_of_study(const fs::path& results, const std::vector<StoredResponses>& stored) {
  auto study = read_stored_materials(results);
  for (const auto& one : stored) {
    if (one.deck_hash == study.deck_hash) continue;
    throw InputError(
        fmt::format("{}: the responses of stage {} are of another study (deck hash {}) than study.json ({})",
                    results.string(), one.stage, one.deck_hash, study.deck_hash));
  }
  return std::move(study.materials);
}

}  // namespace breccia::cli
