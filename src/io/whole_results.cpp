#include "io/whole_results.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/empty_directory.hpp"
#include "io/file_status.hpp"
#include "io/replacement.hpp"
#include "io/text_file.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Remedy = ResultConflict::Remedy;
using Json = nlohmann::ordered_json;

ConflictingResults refusal(const std::string& problem, Remedy remedy) {
  return ConflictingResults(std::vector{ResultConflict{problem, remedy}});
}

/// Throws ConflictingResults if there are mistakes; their texts contain the remedies.
void refuse_all(const std::vector<std::string>& mistakes) {
  std::vector<ResultConflict> conflicts;
  conflicts.reserve(mistakes.size());
  for (const auto& mistake : mistakes) conflicts.push_back({mistake, Remedy::none});
  if (!conflicts.empty()) throw ConflictingResults(std::move(conflicts));
}

bool is_of_breccia(const Json& record) {
  return record.is_object() && record.value("program", Json()) == "breccia";
}

/// The directory itself. Throws ConflictingResults if it is in the unfinished results of a run, which could not be
/// resumed with other files in them.
const fs::path& outside_of_unfinished(const fs::path& directory) {
  const auto results = results_with_unfinished(directory);
  if (!results) return directory;
  throw refusal(fmt::format("{}: the results in {} are not finished, and other files there would prevent their "
                            "run from being resumed",
                            directory.string(), (*results / unfinished_directory).string()),
                Remedy::another_directory);
}

}  // namespace

WholeResults::WholeResults(fs::path directory, ResultsOrigin origin)
    : lock_(outside_of_unfinished(directory)),
      directory_(std::move(directory)),
      origin_(std::move(origin)),
      place_(directory_ / unfinished_directory) {
  refuse_links();
  refuse_others();
  refuse_directories();
  refuse_foreign_unfinished();
  refuse_all(mistakes_of_replacement(directory_, names()));
  finish_replacement(directory_, names());
  make_directory(place_);
  try {
    remove_partial_files(place_,
                         [this](std::string_view name) { return is_own_file(name) || is_replacement_list(name); });
    // The record is written first: it identifies the files that a killed command leaves.
    write_record();
    remove_files(place_, origin_.files);
  } catch (const Error&) {
    remove_place();
    throw;
  }
}

WholeResults::~WholeResults() {
  try {
    // Once old files are being removed, the new ones must be kept: the next command completes the replacement.
    if (is_being_replaced(directory_)) return;
  } catch (const Error&) {
    return;  // no file is removed where the state of the replacement is unknown
  }
  remove_place();
}

void WholeResults::remove_place() const noexcept {
  std::error_code ignored;
  for (const auto& name : origin_.files) fs::remove(place_ / name, ignored);
  fs::remove(place_ / record_name(), ignored);
  remove_if_empty(place_);
}

bool WholeResults::is_own_file(std::string_view name) const {
  return name == record_name() || std::ranges::find(origin_.files, name) != origin_.files.end();
}

ResultNames WholeResults::names() const {
  return {record_name(), [this](std::string_view name) { return is_own_file(name); }};
}

void WholeResults::refuse_links() const {
  auto paths = origin_.files;
  paths.push_back(record_name());
  paths.emplace_back(unfinished_directory);
  refuse_all(mistakes_of_links(directory_, paths));
}

void WholeResults::refuse_others() const {
  for (const auto& record : {directory_ / "study.json", directory_ / "sweep.json", place_ / "study.json"}) {
    if (!fs::exists(status_of(record))) continue;
    throw refusal(fmt::format("{}: here are the results of a {}", directory_.string(), record.stem().string()),
                  Remedy::another_directory);
  }
  // A replacement that was interrupted is completed once there is no conflict: its files count as in place.
  const auto replaced = files_of_replacement(directory_, names());
  const bool is_record_new = !replaced.empty() && fs::exists(status_of(place_ / record_name()));
  const auto record = (is_record_new ? place_ : directory_) / record_name();
  if (fs::is_regular_file(status_of(record))) {
    const auto json = Json::parse(read_text(record), nullptr, false);
    const bool is_ours = is_of_breccia(json);
    if (is_ours && (origin_.overwrite || json.value("identity", Json()) == origin_.identity)) return;
    if (is_ours) {
      const auto before = json.value("source", Json());
      throw refusal(
          fmt::format("{}: here is what `breccia {}` made of {}{}", directory_.string(), origin_.command, before.dump(),
                      before == origin_.source ? ", whose content was another then"
                                               : fmt::format(", not of {}", Json(origin_.source).dump())),
          Remedy::replacing_it);
    }
  }
  std::vector<std::string> foreign;
  for (const auto& name : origin_.files) {
    const bool is_ours = std::ranges::find(replaced, name) != replaced.end();
    if (!is_ours && fs::exists(status_of(directory_ / name))) foreign.push_back(name);
  }
  if (fs::exists(status_of(record))) foreign.push_back(record_name());
  if (foreign.empty()) return;
  throw refusal(fmt::format("{}: the results would replace {}, which `breccia {}` did not write", directory_.string(),
                            fmt::join(foreign, ", "), origin_.command),
                Remedy::another_directory);
}

void WholeResults::refuse_directories() const {
  auto names = origin_.files;
  names.push_back(record_name());
  std::erase_if(names, [&](const std::string& name) { return !fs::is_directory(status_of(directory_ / name)); });
  if (names.empty()) return;
  throw refusal(
      fmt::format("{}: directories are where the results are to be, {}", directory_.string(), fmt::join(names, ", ")),
      Remedy::another_directory);
}

void WholeResults::refuse_foreign_unfinished() const {
  const auto files = unfinished_files(directory_);
  const bool has_record = std::ranges::find(files, record_name()) != files.end() &&
                          is_of_breccia(Json::parse(read_text(place_ / record_name()), nullptr, false));
  std::vector<std::string> foreign;
  for (const auto& name : files) {
    const bool is_file = fs::is_regular_file(fs::symlink_status(place_ / name));
    if (!has_record || !is_file || !is_own_file(name)) foreign.push_back((place_ / name).string());
  }
  if (foreign.empty()) return;
  throw InputError(
      fmt::format("{}: in the way of unfinished results, and not written by `breccia {}`; move it elsewhere",
                  fmt::join(foreign, ", "), origin_.command));
}

void WholeResults::write_record() const {
  const Json json = {{"program", "breccia"},
                     {"version", BRECCIA_VERSION},
                     {"command", origin_.command},
                     {"source", origin_.source},
                     {"identity", origin_.identity}};
  write_text(place_ / record_name(), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void WholeResults::commit() {
  auto old = origin_.files;
  old.push_back(record_name());
  replace_results(directory_, old, names());
}

}  // namespace breccia
