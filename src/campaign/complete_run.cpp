#include "campaign/complete_run.hpp"

#include <nlohmann/json.hpp>

namespace breccia {

std::string text_of(const std::vector<CompleteRun>& runs) {
  auto json = nlohmann::json::array();
  for (const auto& [seconds, note] : runs) {
    json.push_back({seconds ? nlohmann::json(*seconds) : nlohmann::json(), note});
  }
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<CompleteRun> complete_runs_in(const std::string& text) {
  std::vector<CompleteRun> runs;
  for (const auto& json : nlohmann::json::parse(text)) {
    const auto seconds = json[0].is_null() ? std::nullopt : std::optional(json[0].get<double>());
    runs.push_back({seconds, json[1].get<std::string>()});
  }
  return runs;
}

}  // namespace breccia
