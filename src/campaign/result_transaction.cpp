#include "campaign/result_transaction.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/result_conflicts.hpp"
#include "io/empty_directory.hpp"
#include "io/text_file.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "results/checksums.hpp"
#include "results/provenance.hpp"
#include "results/result_files.hpp"
#include "results/stored_study.hpp"
#include "results/study_document.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// Removes files of a directory, in their order, the half-written files there and in its subdirectories, and
/// subdirectories that are then empty.
void remove_results(const fs::path& directory, const std::vector<std::string>& names,
                    const std::vector<std::string>& subdirectories) {
  remove_files(directory, names);
  for (const auto& name : subdirectories) {
    remove_partial_stage_files(directory / name);
    remove_if_empty(directory / name);
  }
  remove_partial_study_files(directory);
}

bool is_record(const std::string& name) {
  return name == "study.json";
}

/// Whether the directory has nothing but the record of a study of which nothing is packed. A record that cannot be read
/// is not known to be one.
bool has_only_a_record(const fs::path& directory) noexcept {
  try {
    if (std::distance(fs::directory_iterator(directory), fs::directory_iterator()) != 1) return false;
    const auto record = read_study_record(directory);
    return record.is_ours && record.stages_packed.empty() && !record.has_tests;
  } catch (const std::exception&) {
    return false;
  }
}

void remove_without_result(const fs::path& directory) noexcept {
  std::error_code is_missing;
  if (has_only_a_record(directory)) fs::remove(directory / "study.json", is_missing);
  remove_if_empty(directory);
}

}  // namespace

ResultTransaction::ResultTransaction(const Study& study, fs::path directory, RunOptions options)
    : options_(std::move(options)), earlier_(study, std::move(directory)) {
  parallel::done_by_first([&] {
    if (!is_missing_or_empty(earlier_.directory)) open();
  });
}

ResultTransaction::~ResultTransaction() {
  if (place_.empty() || parallel::rank() != 0) return;
  for (const auto& stage : study().stages) remove_if_empty(place_ / stage.name);
  remove_without_result(place_);
  remove_without_result(directory());
}

/// A directory that was missing at first is locked, and read, when the work begins.
void ResultTransaction::open() {
  if (lock_) return;
  lock_.emplace(directory());
  earlier_.read();
}

CompleteRun ResultTransaction::take_over() {
  CompleteRun run;
  parallel::done_by_first([&] {
    if (lock_) run = taken_over();
  });
  return complete_runs_in(parallel::text_of_first(text_of({run}))).front();
}

CompleteRun ResultTransaction::taken_over() {
  if (!conflicts_with(earlier_, {.resume = true}).empty()) return {};  // a run will refuse them
  complete_replacement();
  if (!earlier_.are_complete()) return {};
  const auto seconds = earlier_.results.wall_time;
  remove_partial_files(study(), directory());
  const bool is_cut_off = !checkpoint_files(study(), directory()).empty();
  const auto damaged = damaged_files(directory());
  if (!damaged && !is_cut_off) return taken_over_unchecked();
  const bool is_page_alone = damaged == std::vector<std::string>{"report.html"};
  if (is_cut_off || is_page_alone) close_results(study(), directory(), read_study_document(directory()));
  if (is_cut_off || is_page_alone || damaged->empty()) return {seconds, {}};
  return {std::nullopt, fmt::format("{}: missing or changed since the run: {}; it is computed again",
                                    directory().string(), fmt::join(*damaged, ", "))};
}

/// Complete results without checksums are taken if they can be read.
CompleteRun ResultTransaction::taken_over_unchecked() const {
  const auto missing =
      fmt::format("{}: missing since the run: checksums.txt, against which the other files cannot be checked now",
                  directory().string());
  try {
    static_cast<void>(read_stored_study(directory()));
    close_results(study(), directory(), read_study_document(directory()));
    return {earlier_.results.wall_time, fmt::format("{}; it is written anew for the files as they are", missing)};
  } catch (const Error& error) {
    return {std::nullopt, fmt::format("{}; {}; it is computed again", missing, error.what())};
  }
}

void ResultTransaction::begin_run() {
  begin([&] { return options_.resume; });
}

void ResultTransaction::begin_packing() {
  begin([&] { return options_.resume || (earlier_.are_of_the_study() && earlier_.results.has_tests); });
}

void ResultTransaction::begin(const std::function<bool()>& is_resumed) {
  parallel::done_by_first([&] {
    open();
    if (auto conflicts = conflicts_with(earlier_, options_); !conflicts.empty()) {
      throw ConflictingResults(std::move(conflicts));
    }
    complete_replacement();
    resumes_ = is_resumed() && conflicts_of_resuming(earlier_).empty();
    if (resumes_) {
      keep_earlier();
    } else {
      make_way();
    }
    // A later run needs the record to report differences, even if this one ends in its first packing.
    if (!fs::exists(place_ / "study.json")) write_provenance(place_, study(), {});
  });
  const auto answer =
      parallel::text_of_first(fmt::format("{}{}{}", resumes_ ? '+' : '-', keeps_tests_ ? '+' : '-', place_.string()));
  resumes_ = answer[0] == '+';
  keeps_tests_ = answer[1] == '+';
  place_ = answer.substr(2);
}

/// Completes a replacement that was interrupted, which the decision on conflicts has counted as complete.
void ResultTransaction::complete_replacement() {
  const bool is_begun = is_being_replaced(directory());
  // An interrupted run of the same study was to replace complete results by identical ones.
  const bool is_needless = earlier_.are_complete() && earlier_.unfinished.is_of(provenance());
  if (is_begun) {
    finish_replacement(directory(), names_of_results());
  } else if (earlier_.are_beside) {
    replace_earlier();
  } else if (is_needless) {
    remove_unfinished();
  } else {
    return;
  }
  earlier_.read();
}

/// Chooses the place of the earlier results: `unfinished` if only that has results of this study.
void ResultTransaction::keep_earlier() {
  const bool are_unfinished = !earlier_.are_of_the_study() && earlier_.unfinished.is_of(provenance());
  place_ = are_unfinished ? earlier_.unfinished_place() : directory();
  keeps_tests_ = (are_unfinished ? earlier_.unfinished : earlier_.results).has_tests;
  make_directory(place_);
  remove_partial_files(study(), place_);
}

/// Chooses and clears the place of a run that starts anew: `unfinished` if there are results to keep until its end.
void ResultTransaction::make_way() {
  const auto& results = earlier_.results;
  if (results.stages_packed.empty() && !results.has_tests && !earlier_.holds_sweep) {
    // The record is removed last, since it identifies the other files as Breccia's.
    auto names = earlier_.own_files;
    std::stable_partition(names.begin(), names.end(), std::not_fn(is_record));
    remove_results(directory(), names, results.stages);
    place_ = directory();
  } else {
    remove_unfinished();
    place_ = earlier_.unfinished_place();
  }
  make_directory(place_);
}

void ResultTransaction::commit() {
  parallel::done_by_first([&] {
    if (place_ != directory()) replace_earlier();
  });
}

void ResultTransaction::replace_earlier() const {
  const auto written = earlier_.unfinished_place();
  remove_partial_files(study(), written);
  try {
    replace_results(directory(), earlier_.own_files, names_of_results());
  } catch (const FileError& error) {
    if (is_being_replaced(directory())) throw;
    throw FileError(fmt::format("{}; the new results are in {}", error.what(), written.string()));
  }
}

/// Removes all files of Breccia in `unfinished`. The record is removed first, so that files left by a killed process
/// are not taken for complete results; they are identified by their names.
void ResultTransaction::remove_unfinished() const {
  const auto unfinished = earlier_.unfinished_place();
  auto names = unfinished_files(directory());
  std::erase_if(names, [&](const std::string& name) { return !earlier_.has_left_unfinished(name); });
  std::stable_partition(names.begin(), names.end(), is_record);
  std::vector<std::string> subdirectories;
  std::error_code is_missing;
  for (const auto& entry : fs::directory_iterator(unfinished, is_missing)) {
    if (fs::is_directory(entry.symlink_status())) subdirectories.push_back(entry.path().filename().string());
  }
  remove_results(unfinished, names, subdirectories);
  remove_if_empty(unfinished);
}

}  // namespace breccia
