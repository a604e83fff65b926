#include "breccia/study/resume.hpp"

#include <nlohmann/json.hpp>

#include "breccia/io/text_file.hpp"

namespace breccia {

std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto file = directory / "study.json";
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  // What is not as we write it is not of this version.
  const auto has = [&](const char* key, const nlohmann::json& value) {
    return json.contains(key) && json[key] == value;
  };
  const bool is_this_run = has("complete", true) && has("hash", study.hash) && has("version", BRECCIA_VERSION);
  if (!is_this_run || !json.contains("wall_time_s") || !json["wall_time_s"].is_number()) return std::nullopt;
  return json["wall_time_s"].get<double>();
}

}  // namespace breccia
