#include "breccia/study/resume.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/study/report.hpp"

#include "checkpoints.hpp"

namespace breccia {
namespace {

using Json = nlohmann::json;

/// The provenance in a directory, as far as it is one: what is not as we write it is not of this version.
Json provenance_in(const std::filesystem::path& directory) {
  const auto file = directory / "study.json";
  if (!std::filesystem::is_regular_file(file)) return Json::object();
  auto json = Json::parse(read_text(file), nullptr, false);
  return json.is_object() ? json : Json::object();
}

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
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

std::string difference(const Json& before, const Study& now) {
  const auto deck = difference(text_at(before, "deck_text"), now.deck_text);
  if (!deck.empty()) return fmt::format("{}: {}", now.deck.string(), deck);
  const auto overrides = before.find("overrides");
  if (overrides != before.end() && *overrides != Json(now.overrides)) {
    return fmt::format("the overrides were {}, are {}", overrides->dump(), Json(now.overrides).dump());
  }
  return "a data file differs";
}

}  // namespace

std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto json = provenance_in(directory);
  const auto has = [&](const char* key, const Json& value) { return json.contains(key) && json[key] == value; };
  const bool is_this_run = has("complete", true) && has("hash", study.hash) && has("version", BRECCIA_VERSION);
  if (!is_this_run || !json.contains("wall_time_s") || !json["wall_time_s"].is_number()) return std::nullopt;
  return json["wall_time_s"].get<double>();
}

std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto seconds = time_of_complete_run(study, directory);
  if (!seconds || !parallel::is_first()) return seconds;
  remove_partial_files(study, directory);
  if (remove_checkpoints(study, directory)) write_study_report(directory);
  return seconds;
}

bool holds_tests(const std::filesystem::path& directory) {
  const auto json = provenance_in(directory);
  const auto stages = json.find("stages");
  return stages != json.end() && std::ranges::any_of(*stages, [](const Json& stage) {
           return stage.is_object() && stage.contains("tests") && !stage["tests"].empty();
         });
}

void require_same_study(const Study& study, const std::filesystem::path& directory) {
  const auto json = provenance_in(directory);
  const auto version = text_at(json, "version"), hash = text_at(json, "hash");
  if (hash.empty()) return;
  const auto refuse = [&](const std::string& what) {
    throw InputError(
        fmt::format("{}: cannot go on from these results: {}; take another directory (--out), or run without --resume, "
                    "which begins anew and replaces them",
                    directory.string(), what));
  };
  if (version != BRECCIA_VERSION) {
    refuse(fmt::format("they are of version {} of Breccia, this is version {}", version, BRECCIA_VERSION));
  }
  if (hash != study.hash) refuse(difference(json, study));
}

}  // namespace breccia
