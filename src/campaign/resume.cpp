#include "campaign/resume.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/checkpoints.hpp"
#include "campaign/result_directory.hpp"
#include "io/directory_lock.hpp"
#include "io/empty_directory.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "results/checksums.hpp"
#include "results/study_record.hpp"

namespace breccia {

std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto record = read_study_record(directory);
  return record.is_complete_run_of(study) ? record.wall_time : std::nullopt;
}

namespace {

/// Completes a run that was killed after its last test. Returns a note if its files were damaged later. Only the first
/// process may call it.
std::string note_on_complete_run(const Study& study, const std::filesystem::path& directory) {
  if (is_missing_or_empty(directory)) return {};
  const DirectoryLock lock(directory);
  if (!conflicts_with(study, directory, {.resume = true}).empty()) return {};  // a run will refuse them
  finish_interrupted_replacement(study, directory);
  if (!time_of_complete_run(study, directory)) return {};
  remove_partial_files(study, directory);
  const auto damaged = damaged_files(directory).value_or(std::vector<std::string>());
  const bool is_page_alone = damaged == std::vector<std::string>{"report.html"};
  const bool is_closed = checkpoint_files(study, directory).empty();
  if (!is_closed || is_page_alone) close_results(study, directory);
  if (!is_closed || is_page_alone || damaged.empty()) return {};
  return fmt::format("{}: missing or changed since the run: {}; it is computed again", directory.string(),
                     fmt::join(damaged, ", "));
}

}  // namespace

std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory,
                                             const RunObserver& observer) {
  std::string note;
  if (parallel::group() == 0) parallel::done_by_first([&] { note = note_on_complete_run(study, directory); });
  // All processes wait until the files are in their places, and have the note of the first one.
  note = parallel::gather(note).front();
  if (note.empty()) return time_of_complete_run(study, directory);
  observer.tell(Note{note});
  return std::nullopt;
}

bool holds_tests(const std::filesystem::path& directory) {
  return read_study_record(directory).has_tests;
}

}  // namespace breccia
