#include "campaign/result_directory.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "campaign/checkpoints.hpp"
#include "io/directory_lock.hpp"
#include "io/empty_directory.hpp"
#include "io/replacement.hpp"
#include "io/text_file.hpp"
#include "results/checksums.hpp"
#include "results/result_files.hpp"
#include "results/study_record.hpp"
#include "study/identity.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Conflicts = std::vector<ResultConflict>;
using Remedy = ResultConflict::Remedy;

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

bool is_among(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// The names that the results of a study have, and those of a sweep that they replace.
ResultNames names_of_results() {
  return {"study.json",
          [](std::string_view name) { return is_file_of_a_study(name) || is_among(files_of_a_sweep(), name); }};
}

/// The files that Breccia has written to a directory, relative to it.
std::vector<std::string> own_files(const fs::path& directory, const StudyRecord& record) {
  auto names = record.is_ours ? study_files_in(directory, record.stages) : unchanged_files(directory);
  if (!holds_sweep(directory)) return names;
  for (auto& name : sweep_files_in(directory)) {
    if (!is_among(names, name)) names.push_back(std::move(name));
  }
  return names;
}

/// The files that Breccia has written to a results directory. A replacement that was interrupted counts as complete,
/// since it is completed once there are no conflicts.
struct Contents {
  Provenance provenance;  ///< provenance of the study that is to be run
  StudyRecord results, unfinished;
  fs::path record;                     ///< the file of the results' record
  std::vector<std::string> own_files;  ///< relative to the directory
  bool holds_sweep = false;
  bool has_lost_record = false;  ///< whether the files are complete results whose record is missing or damaged
};

Contents contents_of(const Study& study, const fs::path& directory) {
  const auto unfinished = unfinished_in(directory);
  Contents contents = {.provenance = provenance_of(study),
                       .results = read_study_record(directory),
                       .unfinished = read_study_record(unfinished),
                       .record = directory / "study.json",
                       .own_files = {},
                       .holds_sweep = holds_sweep(directory)};
  contents.own_files = own_files(directory, contents.results);
  contents.has_lost_record = !contents.results.is_ours && !unchanged_files(directory).empty();
  const auto replaced = files_of_replacement(directory, names_of_results());
  const bool is_complete = contents.unfinished.is_complete_run_of(contents.provenance);
  if (replaced.empty() && !is_complete) return contents;
  contents.holds_sweep = contents.holds_sweep && !is_complete && !is_among(replaced, "sweep.json");
  std::ranges::copy(replaced, std::back_inserter(contents.own_files));
  if (contents.unfinished.is_ours) {
    contents.results = std::exchange(contents.unfinished, {});
    contents.record = unfinished / "study.json";
  }
  return contents;
}

/// A conflict with each file that a run would replace and that Breccia did not write.
Conflicts conflicts_with_foreign_files(const Study& study, const fs::path& directory, const Contents& contents) {
  Conflicts foreign;
  for (const auto& name : study_files_in(directory, names_of_stages(study))) {
    if (is_among(contents.own_files, name)) continue;
    foreign.push_back({fmt::format("{}: the results would replace this file, which Breccia did not write",
                                   (directory / name).string())});
  }
  return foreign;
}

/// Whether a file in `unfinished` (a relative name) has a name that Breccia writes there. The name is decisive since
/// the record may be missing: a run that was killed while it cleared the directory may have left any of the files.
bool may_be_ours(const fs::path& unfinished, const std::string& name) {
  if (!fs::is_regular_file(fs::symlink_status(unfinished / name))) return false;
  if (!is_file_of_a_study(name)) return false;
  return fs::path(name).extension() != ".json" || is_record_of_breccia(unfinished / name);
}

/// A conflict with each file in `unfinished` that Breccia did not write.
Conflicts conflicts_with_foreign_unfinished(const fs::path& directory) {
  const auto unfinished = unfinished_in(directory);
  Conflicts foreign;
  for (const auto& name : unfinished_files(directory)) {
    if (may_be_ours(unfinished, name)) continue;
    foreign.push_back(
        {fmt::format("{}: in the way of unfinished results, and not written by Breccia; move it elsewhere",
                     (unfinished / name).string()),
         Remedy::none});
  }
  return foreign;
}

Conflicts without_remedy(const std::vector<std::string>& problems) {
  Conflicts conflicts;
  for (const auto& problem : problems) conflicts.push_back({problem, Remedy::none});
  return conflicts;
}

/// A conflict with each symbolic link below the directory through which files elsewhere would be written or removed.
Conflicts conflicts_with_links(const Study& study, const fs::path& directory, const Contents& contents) {
  auto stages = names_of_stages(study);
  for (const auto* record : {&contents.results, &contents.unfinished}) {
    std::ranges::copy(record->stages, std::back_inserter(stages));
  }
  auto names = study_files_in(directory, stages);
  std::ranges::copy(contents.own_files, std::back_inserter(names));
  for (const auto& stage : stages) {
    names.push_back(stage);
    names.push_back((fs::path(unfinished_directory) / stage).string());
  }
  names.emplace_back(unfinished_directory);
  return without_remedy(mistakes_of_links(directory, names));
}

/// A conflict if the results of a study would replace one of its input files.
Conflicts conflicts_with_inputs(const Study& study, const fs::path& directory, const Contents& contents) {
  auto names = contents.own_files;
  std::ranges::copy(study_files_in(directory, names_of_stages(study)), std::back_inserter(names));
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  try {
    refuse_to_replace(directory, names, study.provenance.inputs);
  } catch (const InputError& error) {
    return without_remedy({error.what()});
  }
  return {};
}

/// Removes files of a directory, the half-written files of its subdirectories, and subdirectories that are then empty.
/// The record is removed last, since it identifies the other files as Breccia's.
void remove_results(const fs::path& directory, std::vector<std::string> names, const std::vector<std::string>& stages) {
  const std::vector<std::string> record = {"study.json"};
  const bool has_record = std::erase(names, record.front()) > 0;
  remove_files(directory, names);
  for (const auto& stage : stages) {
    remove_partial_stage_files(directory / stage);
    remove_if_empty(directory / stage);
  }
  remove_partial_study_files(directory);
  if (has_record) remove_files(directory, record);
}

/// The directory, after removing the files of an earlier run that has finished nothing.
fs::path cleared(const fs::path& directory) {
  const auto record = read_study_record(directory);
  remove_results(directory, own_files(directory, record), record.stages);
  make_directory(directory);
  remove_partial_study_files(directory);
  return directory;
}

/// Removes all files of Breccia in `unfinished`. The record is removed first, so that files left by a killed process
/// are not taken for complete results; they are identified by their names.
void remove_unfinished(const fs::path& directory) {
  const auto unfinished = unfinished_in(directory);
  auto names = unfinished_files(directory);
  std::erase_if(names, [&](const std::string& name) { return !may_be_ours(unfinished, name); });
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "study.json"; });
  remove_files(unfinished, names);
  std::vector<std::string> stages;
  std::error_code is_missing;
  for (const auto& entry : fs::directory_iterator(unfinished, is_missing)) {
    if (fs::is_directory(entry.symlink_status())) stages.push_back(entry.path().filename().string());
  }
  remove_results(unfinished, {}, stages);
  remove_if_empty(unfinished);
}

Conflicts conflicts_of_lost_record(const Contents& contents) {
  if (!contents.has_lost_record) return {};
  const auto* const what = fs::exists(contents.record) ? "damaged, or not written by Breccia," : "missing,";
  return {{fmt::format("{}: {} so that nothing tells which study the results here are of; remove them",
                       contents.record.string(), what),
           Remedy::none}};
}

Conflicts conflicts_with_sweep(const fs::path& directory, const Contents& contents) {
  if (!contents.holds_sweep) return {};
  return {{fmt::format("{}: here are the results of a sweep", directory.string()), Remedy::replacing}};
}

Conflicts conflicts_of_resuming(const Study& study, const fs::path& directory, const Contents& contents) {
  const auto& record = contents.results;
  if (record.is_of(contents.provenance) || contents.unfinished.is_of(contents.provenance)) return {};
  if (!record.is_ours) {
    for (auto conflicts :
         {conflicts_of_lost_record(contents), conflicts_with_foreign_files(study, directory, contents)}) {
      if (!conflicts.empty()) return conflicts;
    }
    return conflicts_with_sweep(directory, contents);
  }
  return {{fmt::format("{}: cannot resume from these results: {}", directory.string(), difference(record, study)),
           Remedy::not_resuming}};
}

/// Whether the results of a record may be replaced.
bool may_be_replaced(const fs::path& record, const RunOptions& options) {
  if (options.overwrite) return true;
  return !options.replaceable.empty() && is_record_of_breccia(record) &&
         is_among(options.replaceable, content_hash(read_text(record)));
}

/// The conflict of replacing the results of a record that are in a directory or in its `unfinished`.
Conflicts conflicts_of_replacing(const Study& study, const fs::path& place, const StudyRecord& record,
                                 const fs::path& file, const RunOptions& options) {
  if (!record.has_tests || may_be_replaced(file, options)) return {};
  return {{fmt::format("{}: here are {}results of another study: {}", place.string(),
                       record.is_complete ? "complete " : "", difference(record, study)),
           Remedy::replacing}};
}

Conflicts conflicts_of_replacing(const Study& study, const fs::path& directory, const Contents& contents,
                                 const RunOptions& options) {
  auto conflicts = options.overwrite ? Conflicts() : conflicts_of_lost_record(contents);
  if (!conflicts.empty()) return conflicts;
  const auto unfinished = unfinished_in(directory);
  if (!contents.results.is_of(contents.provenance)) {
    conflicts = conflicts_of_replacing(study, directory, contents.results, contents.record, options);
  }
  if (conflicts.empty() && !contents.unfinished.is_of(contents.provenance)) {
    conflicts = conflicts_of_replacing(study, unfinished, contents.unfinished, unfinished / "study.json", options);
  }
  if (!conflicts.empty() || may_be_replaced(directory / "sweep.json", options)) return conflicts;
  return conflicts_with_sweep(directory, contents);
}

/// The directory in which a run resumes: `unfinished` if only that has results of this study, else the given directory.
fs::path directory_to_resume_in(const Study& study, const fs::path& directory, const Contents& contents) {
  auto unfinished = unfinished_in(directory);
  if (!contents.results.is_of(contents.provenance) && contents.unfinished.is_of(contents.provenance)) {
    remove_partial_files(study, unfinished);
    return unfinished;
  }
  make_directory(directory);
  remove_partial_files(study, directory);
  return directory;
}

fs::path directory_to_begin_in(const fs::path& directory, const Contents& contents) {
  const bool has_results = !contents.results.stages_packed.empty() || contents.holds_sweep;
  if (!has_results) return cleared(directory);
  remove_unfinished(directory);
  return cleared(unfinished_in(directory));
}

Conflicts conflicts_with(const Study& study, const fs::path& directory, const Contents& contents,
                         const RunOptions& options) {
  for (auto conflicts :
       {conflicts_with_links(study, directory, contents),
        without_remedy(mistakes_of_replacement(directory, names_of_results())),
        conflicts_with_inputs(study, directory, contents), conflicts_with_foreign_unfinished(directory)}) {
    if (!conflicts.empty()) return conflicts;
  }
  if (options.resume) {
    auto conflicts = conflicts_of_resuming(study, directory, contents);
    const bool begins_anew =
        may_be_replaced(contents.record, options) || may_be_replaced(directory / "sweep.json", options);
    if (conflicts.empty() || !begins_anew) return conflicts;
  }
  auto conflicts = conflicts_with_foreign_files(study, directory, contents);
  return conflicts.empty() ? conflicts_of_replacing(study, directory, contents, options) : conflicts;
}

/// The content of a directory to which a run may write, after the completion of an interrupted replacement. Throws
/// ConflictingResults before any change.
Contents prepared(const Study& study, const fs::path& directory, const RunOptions& options) {
  auto conflicts = conflicts_with(study, directory, contents_of(study, directory), options);
  if (!conflicts.empty()) throw ConflictingResults(std::move(conflicts));
  finish_interrupted_replacement(study, directory);
  return contents_of(study, directory);
}

}  // namespace

void finish_interrupted_replacement(const Study& study, const fs::path& directory) {
  finish_replacement(directory, names_of_results());
  const auto unfinished = unfinished_in(directory);
  const auto record = read_study_record(unfinished);
  if (!record.is_ours) return;
  const auto provenance = provenance_of(study);
  if (!record.is_of(provenance)) return;
  if (record.is_complete_run_of(provenance)) {
    put_in_place(study, unfinished, directory);
  } else if (read_study_record(directory).is_complete_run_of(provenance)) {
    // An interrupted run of the same study was to replace these results by identical ones.
    remove_unfinished(directory);
  }
}

std::vector<std::string> hashes_of_records_in(const fs::path& directory) {
  std::vector<std::string> hashes;
  for (const auto& record :
       {directory / "study.json", directory / "sweep.json", unfinished_in(directory) / "study.json"}) {
    if (is_record_of_breccia(record)) hashes.push_back(content_hash(read_text(record)));
  }
  return hashes;
}

Conflicts conflicts_with(const Study& study, const fs::path& directory, const RunOptions& options) {
  return conflicts_with(study, directory, contents_of(study, directory), options);
}

fs::path directory_to_run_in(const Study& study, const fs::path& directory, const RunOptions& options) {
  const auto contents = prepared(study, directory, options);
  if (options.resume && conflicts_of_resuming(study, directory, contents).empty()) {
    return directory_to_resume_in(study, directory, contents);
  }
  return directory_to_begin_in(directory, contents);
}

fs::path directory_to_pack_in(const Study& study, const fs::path& directory, const RunOptions& options) {
  const auto contents = prepared(study, directory, options);
  const bool has_tests_of_this = contents.results.has_tests && contents.results.is_of(contents.provenance);
  if (options.resume || has_tests_of_this) return directory_to_resume_in(study, directory, contents);
  return directory_to_begin_in(directory, contents);
}

void put_in_place(const Study& study, const fs::path& written, const fs::path& directory) {
  if (written == directory) return;
  remove_partial_files(study, written);
  try {
    replace_results(directory, own_files(directory, read_study_record(directory)), names_of_results());
  } catch (const FileError& error) {
    if (is_being_replaced(directory)) throw;
    throw FileError(fmt::format("{}; the new results are in {}", error.what(), written.string()));
  }
}

}  // namespace breccia
