#include "sweep_directory.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "breccia/campaign/sweep.hpp"
#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/results/result_files.hpp"
#include "breccia/results/study_record.hpp"
#include "breccia/study/identity.hpp"
#include "breccia/study/result_names.hpp"

#include "result_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// `sweep.json` of a directory; nothing where there is none, or none that Breccia wrote.
Json sweep_record(const fs::path& directory) {
  const auto file = directory / "sweep.json";
  return is_record_of_breccia(file) ? Json::parse(read_text(file), nullptr, false) : Json();
}

bool has_task(const Sweep& sweep, const Json& earlier) {
  return std::ranges::any_of(sweep.tasks, [&](const SweepTask& task) {
    return earlier.value("name", Json()) == task.name && earlier.value("hash", Json()) == task.study.provenance.hash;
  });
}

/// Do the tables of a directory hold finished tasks that the sweep does not have?
bool holds_other_tasks(const Sweep& sweep, const Json& record) {
  const auto tasks = record.is_object() ? record.value("tasks", Json()) : Json();
  return tasks.is_array() && std::ranges::any_of(tasks, [&](const Json& task) {
           return task.is_object() && task.value("state", Json()) == "done" && !has_task(sweep, task);
         });
}

/// The results that the sweep of an earlier process was to replace by those of a task that it has not done.
std::vector<std::string> replaceable_by(const SweepTask& task, const Json& record) {
  const auto tasks = record.is_object() ? record.value("tasks", Json()) : Json();
  std::vector<std::string> hashes;
  if (!tasks.is_array()) return hashes;
  for (const auto& one : tasks) {
    const bool is_waiting = one.is_object() && one.value("name", Json()) == task.name &&
                            one.value("hash", Json()) == task.study.provenance.hash &&
                            one.value("state", Json()) != "done";
    const auto known = is_waiting ? one.value("may_replace", Json::array()) : Json::array();
    for (const auto& hash : known) {
      if (hash.is_string()) hashes.push_back(hash.get<std::string>());
    }
  }
  return hashes;
}

/// What forbids to write the tables of a sweep to a directory; empty if nothing does.
std::string objection_to_tables(const Sweep& sweep, const fs::path& directory, const RunOptions& options) {
  if (read_study_record(directory).has_tests) {
    // Without the slash at the end of `--out results/`.
    const auto name = directory.has_filename() ? directory : directory.parent_path();
    return fmt::format("{}: here are the results of a single study; take another directory (--out {}-sweep)",
                       directory.string(), name.string());
  }
  const auto record = sweep_record(directory);
  if (record.is_null()) {
    for (const auto& name : files_of_a_sweep()) {
      if (!fs::exists(directory / name) || read_study_record(directory).is_ours) continue;
      return fmt::format(
          "{}: the results would replace this file, which Breccia did not write; take another directory "
          "(--out)",
          (directory / name).string());
    }
  }
  if (options.resume || options.overwrite || !holds_other_tasks(sweep, record)) return {};
  return fmt::format(
      "{}: here are the results of another sweep; replace them (--overwrite), add to them (--resume) or "
      "take another directory (--out)",
      directory.string());
}

/// A line for each task that is not as the deck gives it: neither its name nor its hash would tell what it is.
std::vector<std::string> objections_to_changed_tasks(const Sweep& sweep) {
  std::vector<std::string> objections;
  for (const auto& task : sweep.tasks) {
    const auto& provenance = task.study.provenance;
    if (provenance.content == content_of(task.study)) continue;
    objections.push_back(
        fmt::format("{}: this study of a sweep was changed after its deck was read; sweep a key of the deck, or run "
                    "the study alone",
                    task.name.empty() ? task.study.title : task.name));
  }
  return objections;
}

}  // namespace

std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const fs::path& directory, const RunOptions& options) {
  std::vector<RunOptions> all(sweep.tasks.size(), options);
  if (sweep.keys.empty()) return all;
  const auto record = options.resume ? sweep_record(directory) : Json();
  for (std::size_t task = 0; task < all.size(); ++task) {
    all[task].overwrite = false;
    if (options.resume) all[task].replaceable = replaceable_by(sweep.tasks[task], record);
    if (options.overwrite) all[task].replaceable = hashes_of_records_in(sweep.tasks[task].directory_in(directory));
  }
  return all;
}

std::unique_ptr<DirectoryLock> hold_sweep_directory(const Sweep& sweep, const fs::path& directory) {
  if (sweep.keys.empty() || !parallel::is_first()) return nullptr;
  auto lock = std::make_unique<DirectoryLock>(directory);
  for (const auto& task : sweep.tasks) {
    lock_and_finish_interrupted_replacement(task.study, task.directory_in(directory));
  }
  return lock;
}

void refuse_objections(const Sweep& sweep, const fs::path& directory, const RunOptions& options) {
  auto objections = objections_to_changed_tasks(sweep);
  if (!sweep.keys.empty()) objections.push_back(objection_to_tables(sweep, directory, options));
  const auto options_of = options_of_tasks(sweep, directory, options);
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
    const auto& task = sweep.tasks[i];
    objections.push_back(objection_to(task.study, task.directory_in(directory), options_of[i]));
  }
  std::erase(objections, "");
  if (!objections.empty()) throw InputError(fmt::format("{}", fmt::join(objections, "\n")));
}

}  // namespace breccia
