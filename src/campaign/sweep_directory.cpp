#include "campaign/sweep_directory.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "campaign/result_conflicts.hpp"
#include "io/conflicting_results.hpp"
#include "io/empty_directory.hpp"
#include "io/replacement.hpp"
#include "io/text_file.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "results/result_files.hpp"
#include "results/study_record.hpp"
#include "study/identity.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Remedy = ResultConflict::Remedy;

/// The parsed `sweep.json` of a directory; null if it is missing or was not written by Breccia.
nlohmann::json sweep_record(const fs::path& directory) {
  const auto file = directory / "sweep.json";
  return is_record_of_breccia(file) ? nlohmann::json::parse(read_text(file), nullptr, false) : nlohmann::json();
}

bool has_task(const Sweep& sweep, const nlohmann::json& earlier) {
  return std::ranges::any_of(sweep.tasks, [&](const SweepTask& task) {
    return earlier.value("name", nlohmann::json()) == task.name &&
           earlier.value("hash", nlohmann::json()) == task.study.provenance.hash;
  });
}

/// Whether the tables of a directory have finished tasks that the sweep does not have.
bool holds_other_tasks(const Sweep& sweep, const nlohmann::json& record) {
  const auto tasks = record.is_object() ? record.value("tasks", nlohmann::json()) : nlohmann::json();
  return tasks.is_array() && std::ranges::any_of(tasks, [&](const nlohmann::json& task) {
           return task.is_object() && task.value("state", nlohmann::json()) == "done" && !has_task(sweep, task);
         });
}

/// The results that an earlier, unfinished run of the sweep was allowed to replace by those of a task.
std::vector<std::string> replaceable_by(const SweepTask& task, const nlohmann::json& record) {
  const auto tasks = record.is_object() ? record.value("tasks", nlohmann::json()) : nlohmann::json();
  std::vector<std::string> hashes;
  if (!tasks.is_array()) return hashes;
  for (const auto& one : tasks) {
    const bool is_waiting = one.is_object() && one.value("name", nlohmann::json()) == task.name &&
                            one.value("hash", nlohmann::json()) == task.study.provenance.hash &&
                            one.value("state", nlohmann::json()) != "done";
    const auto known = is_waiting ? one.value("may_replace", nlohmann::json::array()) : nlohmann::json::array();
    for (const auto& hash : known) {
      if (hash.is_string()) hashes.push_back(hash.get<std::string>());
    }
  }
  return hashes;
}

/// A directory for a sweep beside one that is taken: `results-sweep` for `results/`, `../study-sweep` for `.` where
/// that is called `study`.
fs::path directory_beside(const fs::path& taken) {
  const auto normal = taken.lexically_normal();
  const auto named = normal.has_filename() ? normal : normal.parent_path();
  const auto name = named.filename();
  if (!name.empty() && name != "." && name != "..") return named.string() + "-sweep";
  const auto real = fs::canonical(taken);
  return (taken / ".." / (real.filename().string() + "-sweep")).lexically_normal();
}

/// The reason why the tables of a sweep must not be written to a directory with this `sweep.json`; nothing if they may.
std::optional<ResultConflict> conflict_with_tables(const Sweep& sweep, const fs::path& directory,
                                                   const nlohmann::json& record, const RunOptions& options) {
  const auto study = read_study_record(directory);
  if (study.has_tests) {
    return ResultConflict{fmt::format("{}: here are the results of a single study", directory.string()),
                          Remedy::another_directory, directory_beside(directory).string()};
  }
  if (record.is_null()) {
    const auto of_study = study.is_ours ? files_of_a_study() : std::vector<std::string>();
    for (const auto& name : files_of_a_sweep()) {
      const bool is_ours = std::ranges::find(of_study, name) != of_study.end();
      if (is_ours || !fs::exists(directory / name)) continue;
      return ResultConflict{fmt::format("{}: the results would replace this file, which Breccia did not write",
                                        (directory / name).string())};
    }
  }
  if (options.resume || options.overwrite || !holds_other_tasks(sweep, record)) return {};
  return ResultConflict{fmt::format("{}: here are the results of another sweep", directory.string()), Remedy::adding};
}

/// The names of the tasks' directories; none for a single task, which has that of the results.
std::vector<std::string> names_of_tasks(const Sweep& sweep) {
  std::vector<std::string> names;
  std::ranges::transform(sweep.tasks, std::back_inserter(names), &SweepTask::name);
  std::erase(names, "");
  return names;
}

/// A conflict with each task that differs from its deck: neither its name nor its hash would identify it.
std::vector<ResultConflict> conflicts_with_changed_tasks(const Sweep& sweep) {
  std::vector<ResultConflict> conflicts;
  for (const auto& task : sweep.tasks) {
    const auto& provenance = task.study.provenance;
    if (provenance.content == content_of(task.study)) continue;
    conflicts.push_back(
        {fmt::format("{}: this study of a sweep was changed after its deck was read; sweep a key of the deck, or run "
                     "the study alone",
                     task.name.empty() ? task.study.title : task.name),
         Remedy::none});
  }
  return conflicts;
}

/// What is in the directory of a task, which is locked meanwhile.
EarlierResults results_before(const SweepTask& task, const fs::path& directory) {
  std::optional<DirectoryLock> lock;
  if (!is_missing_or_empty(directory)) lock.emplace(directory);
  EarlierResults earlier(task.study, directory);
  earlier.read();
  return earlier;
}

}  // namespace

SweepDirectory::SweepDirectory(const Sweep& sweep, fs::path directory, const RunOptions& options)
    : sweep_(sweep),
      directory_(std::move(directory)),
      options_(sweep.tasks.size(), options),
      are_complete_(sweep.tasks.size()) {
  for (auto& of_task : options_) of_task.overwrite = of_task.overwrite && sweep.keys.empty();
  parallel::done_by_first_group([&] { parallel::done_by_first([&] { open(options); }); });
  auto ours = nlohmann::json::array();
  for (std::size_t task = 0; task < options_.size(); ++task) {
    ours.push_back({options_[task].replaceable, static_cast<bool>(are_complete_[task])});
  }
  const auto known = nlohmann::json::parse(parallel::gather(ours.dump()).front());
  for (std::size_t task = 0; task < options_.size(); ++task) {
    options_[task].replaceable = known[task][0].get<std::vector<std::string>>();
    are_complete_[task] = known[task][1].get<bool>();
  }
}

void SweepDirectory::open(const RunOptions& options) {
  auto conflicts = conflicts_with_changed_tasks(sweep_);
  nlohmann::json record;
  const bool has_tables = !sweep_.keys.empty();
  if (has_tables) {
    lock_.emplace(directory_);
    record = sweep_record(directory_);
    if (auto conflict = conflict_with_tables(sweep_, directory_, record, options)) {
      conflicts.push_back(*std::move(conflict));
    }
  }
  for (const auto& mistake : mistakes_of_links(directory_, names_of_tasks(sweep_))) {
    conflicts.push_back({mistake, Remedy::none});
  }
  for (std::size_t i = 0; i < sweep_.tasks.size(); ++i) {
    const auto& task = sweep_.tasks[i];
    const auto earlier = results_before(task, task.directory_in(directory_));
    are_complete_[i] = earlier.are_complete();
    if (has_tables) {
      if (options.resume) options_[i].replaceable = replaceable_by(task, record);
      if (options.overwrite) options_[i].replaceable = earlier.hashes;
    }
    std::ranges::move(conflicts_with(earlier, options_[i]), std::back_inserter(conflicts));
  }
  if (!conflicts.empty()) throw ConflictingResults(std::move(conflicts));
}

std::vector<CompleteRun> SweepDirectory::complete_runs() const {
  std::vector<CompleteRun> runs(sweep_.tasks.size());
  parallel::done_by_first_group([&] {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto& task = sweep_.tasks[i];
      if (!are_complete_[i]) continue;
      runs[i] = ResultTransaction(task.study, task.directory_in(directory_), options_[i]).take_over();
    }
  });
  return complete_runs_in(parallel::gather(text_of(runs)).front());
}

}  // namespace breccia
