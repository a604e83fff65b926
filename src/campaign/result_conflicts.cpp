#include "campaign/result_conflicts.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "results/result_files.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Conflicts = std::vector<ResultConflict>;
using Remedy = ResultConflict::Remedy;

std::vector<std::string> names_of_stages(const Study& study) {
  std::vector<std::string> names;
  std::ranges::transform(study.stages, std::back_inserter(names), &Stage::name);
  return names;
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// The existing files of the directory that have names of the study's results.
std::vector<std::string> files_in_the_way(const EarlierResults& earlier) {
  return study_files_in(earlier.directory, names_of_stages(*earlier.study));
}

/// A conflict with each file that a run would replace and that Breccia did not write.
Conflicts conflicts_with_foreign_files(const EarlierResults& earlier) {
  Conflicts foreign;
  for (const auto& name : files_in_the_way(earlier)) {
    if (is_among(earlier.own_files, name)) continue;
    foreign.push_back({fmt::format("{}: the results would replace this file, which Breccia did not write",
                                   (earlier.directory / name).string())});
  }
  return foreign;
}

/// A conflict with each file in `unfinished` that Breccia did not write.
Conflicts conflicts_with_foreign_unfinished(const EarlierResults& earlier) {
  Conflicts foreign;
  for (const auto& name : unfinished_files(earlier.directory)) {
    if (earlier.has_left_unfinished(name)) continue;
    foreign.push_back(
        {fmt::format("{}: in the way of unfinished results, and not written by Breccia; move it elsewhere",
                     (earlier.unfinished_place() / name).string()),
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
Conflicts conflicts_with_links(const EarlierResults& earlier) {
  auto stages = names_of_stages(*earlier.study);
  for (const auto* record : {&earlier.results, &earlier.unfinished}) {
    std::ranges::copy(record->stages, std::back_inserter(stages));
  }
  auto names = study_files_in(earlier.directory, stages);
  std::ranges::copy(earlier.own_files, std::back_inserter(names));
  for (const auto& stage : stages) {
    names.push_back(stage);
    names.push_back((fs::path(unfinished_directory) / stage).string());
  }
  names.emplace_back(unfinished_directory);
  return without_remedy(mistakes_of_links(earlier.directory, names));
}

/// A conflict if the results of a study would replace one of its input files.
Conflicts conflicts_with_inputs(const EarlierResults& earlier) {
  auto names = earlier.own_files;
  std::ranges::copy(files_in_the_way(earlier), std::back_inserter(names));
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  try {
    refuse_to_replace(earlier.directory, names, earlier.study->provenance.inputs);
  } catch (const InputError& error) {
    return without_remedy({error.what()});
  }
  return {};
}

Conflicts conflicts_of_lost_record(const EarlierResults& earlier) {
  if (!earlier.has_lost_record) return {};
  const auto* const what = fs::exists(earlier.record) ? "damaged, or not written by Breccia," : "missing,";
  return {{fmt::format("{}: {} so that nothing tells which study the results here are of; remove them",
                       earlier.record.string(), what),
           Remedy::none}};
}

Conflicts conflicts_with_sweep(const EarlierResults& earlier) {
  if (!earlier.holds_sweep) return {};
  return {{fmt::format("{}: here are the results of a sweep", earlier.directory.string()), Remedy::replacing}};
}

/// Whether the results may be replaced whose record has this hash, which is empty where there is no record.
bool may_be_replaced(const std::string& hash, const RunOptions& options) {
  return options.overwrite || (!hash.empty() && is_among(options.replaceable, hash));
}

/// The conflict of replacing the results of a record that are in the directory or in its `unfinished`.
Conflicts conflicts_of_replacing(const EarlierResults& earlier, const StudyRecord& record, const fs::path& place,
                                 const RunOptions& options) {
  if (!record.has_tests || record.is_of(earlier.provenance) || may_be_replaced(record.text_hash, options)) return {};
  return {{fmt::format("{}: here are {}results of another study: {}", place.string(),
                       record.is_complete ? "complete " : "", difference(record, *earlier.study)),
           Remedy::replacing}};
}

Conflicts conflicts_of_replacing(const EarlierResults& earlier, const RunOptions& options) {
  auto conflicts = options.overwrite ? Conflicts() : conflicts_of_lost_record(earlier);
  if (!conflicts.empty()) return conflicts;
  conflicts = conflicts_of_replacing(earlier, earlier.results, earlier.directory, options);
  if (!conflicts.empty()) return conflicts;
  conflicts = conflicts_of_replacing(earlier, earlier.unfinished, earlier.unfinished_place(), options);
  if (!conflicts.empty() || may_be_replaced(earlier.sweep_hash, options)) return conflicts;
  return conflicts_with_sweep(earlier);
}

}  // namespace

Conflicts conflicts_of_resuming(const EarlierResults& earlier) {
  if (earlier.are_of_the_study() || earlier.unfinished.is_of(earlier.provenance)) return {};
  if (!earlier.results.is_ours) {
    for (auto conflicts : {conflicts_of_lost_record(earlier), conflicts_with_foreign_files(earlier)}) {
      if (!conflicts.empty()) return conflicts;
    }
    return conflicts_with_sweep(earlier);
  }
  return {{fmt::format("{}: cannot resume from these results: {}", earlier.directory.string(),
                       difference(earlier.results, *earlier.study)),
           Remedy::not_resuming}};
}

Conflicts conflicts_with(const EarlierResults& earlier, const RunOptions& options) {
  for (auto conflicts :
       {conflicts_with_links(earlier), without_remedy(mistakes_of_replacement(earlier.directory, names_of_results())),
        conflicts_with_inputs(earlier), conflicts_with_foreign_unfinished(earlier)}) {
    if (!conflicts.empty()) return conflicts;
  }
  if (options.resume) {
    auto conflicts = conflicts_of_resuming(earlier);
    const bool begins_anew =
        may_be_replaced(earlier.results.text_hash, options) || may_be_replaced(earlier.sweep_hash, options);
    if (conflicts.empty() || !begins_anew) return conflicts;
  }
  auto conflicts = conflicts_with_foreign_files(earlier);
  return conflicts.empty() ? conflicts_of_replacing(earlier, options) : conflicts;
}

}  // namespace breccia
