#include "result_directory.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/replacement.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/results/result_files.hpp"
#include "breccia/results/study_record.hpp"
#include "breccia/study/result_names.hpp"

#include "checkpoints.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

fs::path unfinished_in(const fs::path& directory) {
  return directory / unfinished_directory;
}

bool holds_sweep(const fs::path& directory) {
  return is_record_of_breccia(directory / "sweep.json");
}

std::vector<std::string> names_of_stages(const Study& study) {
  std::vector<std::string> names;
  std::ranges::transform(study.stages, std::back_inserter(names), &Stage::name);
  return names;
}

/// The files that Breccia has written to a directory, relative to it.
std::vector<std::string> own_files(const fs::path& directory, const StudyRecord& record) {
  if (record.is_ours) return result_files_in(directory, record.stages);
  if (!holds_sweep(directory)) return {};
  auto names = files_of_a_sweep();
  std::erase_if(names, [&](const std::string& name) { return !fs::exists(directory / name); });
  return names;
}

/// A line for each file that a run would replace and that Breccia did not write.
std::string objection_to_foreign_files(const Study& study, const fs::path& directory, const StudyRecord& record) {
  const auto ours = own_files(directory, record);
  std::string foreign;
  for (const auto& name : result_files_in(directory, names_of_stages(study))) {
    if (std::ranges::find(ours, name) != ours.end()) continue;
    foreign += fmt::format(
        "{}{}: the results would replace this file, which Breccia did not write; take another "
        "directory (--out)",
        foreign.empty() ? "" : "\n", (directory / name).string());
  }
  return foreign;
}

/// A line for each file in `unfinished` that Breccia did not write.
std::string objection_to_foreign_unfinished(const fs::path& directory) {
  const auto unfinished = unfinished_in(directory);
  const auto ours = own_files(unfinished, read_study_record(unfinished));
  std::string foreign;
  for (const auto& name : unfinished_files(directory)) {
    if (std::ranges::find(ours, name) != ours.end() || name.ends_with(".partial")) continue;
    foreign += fmt::format("{}{}: in the way of unfinished results, and not written by Breccia; move it elsewhere",
                           foreign.empty() ? "" : "\n", (unfinished / name).string());
  }
  return foreign;
}

/// Which of the files from which a study comes its results would replace.
std::string objection_to_inputs(const Study& study, const fs::path& directory) {
  try {
    refuse_to_replace(directory, result_files_in(directory, names_of_stages(study)), study.provenance.inputs);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Removes what Breccia has written to a directory, and directories of stages that are empty then.
void remove_own_files(const fs::path& directory, const StudyRecord& record) {
  remove_files(directory, own_files(directory, record));
  std::vector<fs::path> stages;
  for (const auto& stage : record.stages) {
    remove_partial_files(directory / stage);
    stages.push_back(directory / stage);
  }
  remove_if_empty(stages);
}

/// A directory with nothing of an earlier run in it. One whose study has finished nothing is made so.
fs::path cleared(const fs::path& directory) {
  remove_own_files(directory, read_study_record(directory));
  make_directory(directory);
  remove_partial_files(directory);
  return directory;
}

std::string objection_to_resuming(const Study& study, const fs::path& directory) {
  const auto record = read_study_record(directory);
  if (record.is_of(study) || read_study_record(unfinished_in(directory)).is_of(study)) return {};
  if (!record.is_ours) return objection_to_foreign_files(study, directory, record);
  return fmt::format(
      "{}: cannot go on from these results: {}; take another directory (--out), or run with --overwrite "
      "in the place of --resume, which begins anew and replaces them in the end",
      directory.string(), difference(record, study));
}

std::string objection_to_replacing(const Study& study, const fs::path& directory) {
  const auto* choice = "replace them (--overwrite) or take another directory (--out)";
  for (const auto& place : {directory, unfinished_in(directory)}) {
    const auto record = read_study_record(place);
    if (!record.has_tests || record.is_of(study)) continue;
    return fmt::format("{}: here are {}results of another study: {}; {}", place.string(),
                       record.is_complete ? "complete " : "", difference(record, study), choice);
  }
  if (holds_sweep(directory)) return fmt::format("{}: here are the results of a sweep; {}", directory.string(), choice);
  return {};
}

void refuse_objections(const Study& study, const fs::path& directory, const RunOptions& options) {
  if (const auto objection = objection_to(study, directory, options); !objection.empty()) throw InputError(objection);
}

/// Where earlier results are of the study, there is something to go on from.
fs::path directory_to_resume_in(const Study& study, const fs::path& directory) {
  const auto record = read_study_record(directory);
  const auto unfinished = unfinished_in(directory);
  if (!record.is_of(study) && read_study_record(unfinished).is_of(study)) {
    remove_partial_files(study, unfinished);
    return unfinished;
  }
  make_directory(directory);
  remove_partial_files(study, directory);
  return directory;
}

fs::path directory_to_begin_in(const fs::path& directory) {
  const auto record = read_study_record(directory);
  const bool has_results = !record.stages_packed.empty() || holds_sweep(directory);
  return cleared(has_results ? unfinished_in(directory) : directory);
}

}  // namespace

void finish_interrupted_replacement(const Study& study, const fs::path& directory) {
  finish_replacement(directory);
  const auto unfinished = unfinished_in(directory);
  const auto record = read_study_record(unfinished);
  if (!record.is_of(study)) return;
  if (record.is_complete_run_of(study)) {
    put_in_place(study, unfinished, directory);
  } else if (read_study_record(directory).is_complete_run_of(study)) {
    // Another run of the same study was to replace these results, and would have ended with the same bits.
    remove_own_files(unfinished, record);
    remove_if_empty(std::vector{unfinished});
  }
}

std::string objection_to(const Study& study, const fs::path& directory, const RunOptions& options) {
  for (auto objection : {objection_to_inputs(study, directory), objection_to_foreign_unfinished(directory)}) {
    if (!objection.empty()) return objection;
  }
  if (options.resume && !options.overwrite) return objection_to_resuming(study, directory);
  auto objection = objection_to_foreign_files(study, directory, read_study_record(directory));
  if (objection.empty() && !options.overwrite) objection = objection_to_replacing(study, directory);
  return objection;
}

fs::path directory_to_run_in(const Study& study, const fs::path& directory, const RunOptions& options) {
  finish_interrupted_replacement(study, directory);
  refuse_objections(study, directory, options);
  if (options.resume && objection_to_resuming(study, directory).empty()) {
    return directory_to_resume_in(study, directory);
  }
  return directory_to_begin_in(directory);
}

fs::path directory_to_pack_in(const Study& study, const fs::path& directory, const RunOptions& options) {
  finish_interrupted_replacement(study, directory);
  refuse_objections(study, directory, options);
  const auto record = read_study_record(directory);
  const bool has_tests_of_this = record.has_tests && record.is_of(study);
  if (options.resume || has_tests_of_this) return directory_to_resume_in(study, directory);
  return directory_to_begin_in(directory);
}

void put_in_place(const Study& study, const fs::path& written, const fs::path& directory) {
  if (written == directory) return;
  remove_partial_files(study, written);
  replace_results(directory, own_files(directory, read_study_record(directory)), "study.json");
}

}  // namespace breccia
