#include "studio/result_list.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/text_file.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view results_directory = "results";
constexpr std::string_view page = "report.html";

/// The text of an entry; empty if there is none.
std::string text_of(const nlohmann::json& document, std::string_view key) {
  const auto entry = document.find(key);
  return entry != document.end() && entry->is_string() ? entry->get<std::string>() : "";
}

/// A record of results, by its name in the folder; nothing if there is none, or it cannot be read.
std::optional<nlohmann::json> record_in(const Folder& folder, const std::string& name) {
  try {
    auto document = nlohmann::json::parse(read_text(folder.file(name)), nullptr, false);
    if (document.is_object()) return document;
  } catch (const Error&) {
  }
  return std::nullopt;
}

/// The results in a directory, by its name in the folder; nothing if there are none.
std::optional<ListedResult> result_in(const Folder& folder, const std::string& directory) {
  const auto sweep = record_in(folder, directory + "/sweep.json");
  const auto study = sweep ? std::nullopt : record_in(folder, directory + "/study.json");
  const auto& document = sweep ? sweep : study;
  if (!document) return std::nullopt;
  ListedResult result;
  result.path = directory;
  result.title = text_of(*document, "title");
  result.deck = text_of(*document, "deck");
  result.deck_text = text_of(*document, "deck_text");
  result.date = text_of(*document, "date");
  result.is_sweep = sweep.has_value();
  result.has_page = fs::is_regular_file(folder.path() / directory / page);
  const auto overrides = document->find("overrides");
  result.has_overrides = overrides != document->end() && !overrides->empty();
  const auto complete = document->find("complete");
  result.is_complete = complete != document->end() ? *complete == true : result.has_page;
  const auto seconds = document->find("wall_time_s");
  if (seconds != document->end() && seconds->is_number()) result.seconds = seconds->get<double>();
  return result;
}

bool is_there(const Folder& folder, const std::string& name) {
  return fs::exists(fs::symlink_status(folder.path() / name));
}

/// "results/a", "results/a-2", ...
std::string numbered(const std::string& name, int number) {
  const auto suffix = number == 1 ? "" : fmt::format("-{}", number);
  return fmt::format("{}/{}{}", results_directory, name, suffix);
}

}  // namespace

std::vector<ListedResult> results_in(const Folder& folder) {
  std::vector<ListedResult> results;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder.path() / results_directory, failure)) {
    const auto name = (fs::path(results_directory) / entry.path().filename()).generic_string();
    if (auto result = result_in(folder, name)) results.push_back(std::move(*result));
  }
  std::ranges::sort(results, [](const ListedResult& a, const ListedResult& b) {
    return std::pair(b.date, a.path) < std::pair(a.date, b.path);
  });
  return results;
}

std::string new_directory_for(const Folder& folder, const std::string& name) {
  int number = 1;
  while (is_there(folder, numbered(name, number))) ++number;
  return numbered(name, number);
}

std::string directory_for(const Folder& folder, const std::string& name, const std::string& deck_text) {
  for (int number = 1; is_there(folder, numbered(name, number)); ++number) {
    const auto present = result_in(folder, numbered(name, number));
    if (present && present->deck_text == deck_text && !present->has_overrides) return numbered(name, number);
  }
  return new_directory_for(folder, name);
}

}  // namespace breccia::studio
