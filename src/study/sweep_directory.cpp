#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/study/sweep.hpp"

#include "result_directory.hpp"
#include "result_files.hpp"
#include "study_record.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// `sweep.json` of a directory; nothing where there is none, or none that Breccia wrote.
Json sweep_record(const fs::path& directory) {
  const auto file = directory / "sweep.json";
  if (!fs::is_regular_file(file)) return {};
  auto json = Json::parse(read_text(file), nullptr, false);
  const bool is_ours = json.is_object() && json.value("program", Json()) == "breccia";
  return is_ours ? json : Json();
}

bool has_task(const Sweep& sweep, const Json& earlier) {
  return std::ranges::any_of(sweep.tasks, [&](const SweepTask& task) {
    return earlier.value("name", Json()) == task.name && earlier.value("hash", Json()) == task.study.hash;
  });
}

/// Do the tables of a directory hold finished tasks that the sweep does not have?
bool holds_other_tasks(const Sweep& sweep, const Json& record) {
  const auto tasks = record.is_object() ? record.value("tasks", Json()) : Json();
  return tasks.is_array() && std::ranges::any_of(tasks, [&](const Json& task) {
           return task.is_object() && task.value("state", Json()) == "done" && !has_task(sweep, task);
         });
}

/// What forbids to write the tables of a sweep to a directory; empty if nothing does.
std::string objection_to_tables(const Sweep& sweep, const fs::path& directory, const RunOptions& options) {
  if (read_study_record(directory).has_tests) {
    return fmt::format("{}: here are the results of a single study; take another directory (--out)",
                       directory.string());
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

}  // namespace

void refuse_objections(const Sweep& sweep, const fs::path& directory, const RunOptions& options) {
  std::vector<std::string> objections;
  if (!sweep.keys.empty()) objections.push_back(objection_to_tables(sweep, directory, options));
  for (const auto& task : sweep.tasks) {
    objections.push_back(objection_to(task.study, task.directory_in(directory), options));
  }
  std::erase(objections, "");
  if (!objections.empty()) throw InputError(fmt::format("{}", fmt::join(objections, "\n")));
}

}  // namespace breccia
