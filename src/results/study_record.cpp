#include "results/study_record.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

std::string text_at(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<std::string> texts_at(const nlohmann::json& json, const char* key) {
  std::vector<std::string> texts;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) return texts;
  for (const auto& text : *found) {
    if (text.is_string()) texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::vector<FileHash> file_hashes_in(const nlohmann::json& json) {
  std::vector<FileHash> files;
  const auto found = json.find("file_hashes");
  if (found == json.end() || !found->is_object()) return files;
  for (const auto& [name, hash] : found->items()) {
    if (hash.is_string()) files.push_back({name, hash.get<std::string>()});
  }
  return files;
}

std::vector<std::string> safe_names(std::vector<std::string> names) {
  std::erase_if(names, [](const std::string& name) { return !is_safe_name(name); });
  return names;
}

void read_stages(const nlohmann::json& json, StudyRecord& record) {
  record.stages = safe_names(texts_at(json, "stage_names"));
  const auto stages = json.find("stages");
  const bool has_list = stages != json.end() && stages->is_array();
  // Results are taken for those of tests unless they say that there are none: another version may write them elsewhere.
  record.has_tests = record.is_complete || !has_list;
  if (!has_list) return;
  for (const auto& stage : *stages) {
    if (!stage.is_object()) continue;
    record.stages_packed.push_back(text_at(stage, "name"));
    record.has_tests = record.has_tests || !stage.contains("tests") || !stage["tests"].empty();
  }
  record.stages_packed = safe_names(std::move(record.stages_packed));
  for (const auto& name : record.stages_packed) {
    if (std::ranges::find(record.stages, name) == record.stages.end()) record.stages.push_back(name);
  }
}

/// The first line in which two texts differ, as "line 7 was `a`, is `b`"; empty when there is none.
std::string difference(const std::string& before, const std::string& now) {
  std::istringstream lines_before(before), lines_now(now);
  for (int number = 1;; ++number) {
    std::string was, is;
    const bool had = static_cast<bool>(std::getline(lines_before, was));
    const bool has = static_cast<bool>(std::getline(lines_now, is));
    if (!had && !has) return {};
    if (had != has || was != is) return fmt::format("line {} was `{}`, is `{}`", number, was, is);
  }
}

/// The data files that have another content than before, in words.
std::string differing_files(const std::vector<FileHash>& before, const std::vector<FileHash>& now) {
  std::vector<std::string> names;
  for (const auto& file : now) {
    if (std::ranges::find(before, file) == before.end()) names.push_back(file.name);
  }
  if (names.empty()) return "a data file differs";
  return fmt::format("the data file{} {} {}", names.size() == 1 ? "" : "s", fmt::join(names, ", "),
                     names.size() == 1 ? "differs" : "differ");
}

}  // namespace

bool StudyRecord::is_of(const Provenance& provenance) const {
  return is_ours && version == BRECCIA_VERSION && hash == provenance.hash;
}

bool StudyRecord::is_of(const Study& study) const {
  return is_ours && version == BRECCIA_VERSION && is_of(provenance_of(study));
}

bool is_record_of_breccia(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) return false;
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  return json.is_object() && text_at(json, "program") == "breccia";
}

StudyRecord read_study_record(const std::filesystem::path& directory) {
  StudyRecord record;
  const auto file = directory / "study.json";
  if (!std::filesystem::is_regular_file(file)) return record;
  const auto text = read_text(file);
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || text_at(json, "program") != "breccia") return record;
  record.is_ours = true;
  record.text_hash = content_hash(text);
  record.is_complete = json.contains("complete") && json["complete"] == true;
  record.hash = text_at(json, "hash");
  record.version = text_at(json, "version");
  record.deck_content_hash = text_at(json, "deck_content_hash");
  record.file_hashes = file_hashes_in(json);
  record.deck_text = text_at(json, "deck_text");
  record.overrides = texts_at(json, "overrides");
  if (json.contains("wall_time_s") && json["wall_time_s"].is_number()) record.wall_time = json["wall_time_s"];
  read_stages(json, record);
  return record;
}

std::string difference(const StudyRecord& before, const Study& now) {
  if (before.version != BRECCIA_VERSION) {
    return fmt::format("they are of {} of Breccia, this is version {}",
                       before.version.empty() ? "another version" : "version " + before.version, BRECCIA_VERSION);
  }
  const auto provenance = provenance_of(now);
  if (before.deck_text.empty() || provenance.deck_text.empty()) {
    return fmt::format("their hash is {}, that of this study {}, and not both are as a deck gives them", before.hash,
                       provenance.hash);
  }
  // The texts may differ only in comments and in the sweep.
  if (!before.deck_content_hash.empty() && before.deck_content_hash == provenance.deck_content_hash) {
    return differing_files(before.file_hashes, provenance.file_hashes);
  }
  std::vector<std::string> differences;
  const auto deck = difference(before.deck_text, provenance.deck_text);
  if (!deck.empty()) differences.push_back(fmt::format("{}: {}", provenance.deck.string(), deck));
  if (before.overrides != provenance.overrides) {
    differences.push_back(fmt::format("the overrides were {}, are {}", nlohmann::json(before.overrides).dump(),
                                      nlohmann::json(provenance.overrides).dump()));
  }
  if (differences.empty()) return differing_files(before.file_hashes, provenance.file_hashes);
  return fmt::format("{}", fmt::join(differences, "; "));
}

}  // namespace breccia
