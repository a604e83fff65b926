#include "breccia/campaign/resume.hpp"

#include "breccia/io/directory_lock.hpp"
#include "breccia/io/empty_directory.hpp"
#include "breccia/parallel/common_failure.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/results/study_record.hpp"
#include "breccia/results/study_report.hpp"

#include "checkpoints.hpp"
#include "result_directory.hpp"

namespace breccia {

std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto record = read_study_record(directory);
  return record.is_complete_run_of(study) ? record.wall_time : std::nullopt;
}

namespace {

/// Completes a run that was killed after its last test. Only the first process may call it.
void finish_killed_run(const Study& study, const std::filesystem::path& directory) {
  if (is_missing_or_empty(directory)) return;
  const DirectoryLock lock(directory);
  if (!objections_to(study, directory, {.resume = true}).empty()) return;  // a run will refuse them
  finish_interrupted_replacement(study, directory);
  if (!time_of_complete_run(study, directory)) return;
  remove_partial_files(study, directory);
  if (remove_checkpoints(study, directory)) write_study_report(directory);
}

}  // namespace

std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory) {
  if (parallel::group() == 0) parallel::done_by_first([&] { finish_killed_run(study, directory); });
  // All processes wait until the files are in their places.
  static_cast<void>(parallel::gather({}));
  return time_of_complete_run(study, directory);
}

bool holds_tests(const std::filesystem::path& directory) {
  return read_study_record(directory).has_tests;
}

}  // namespace breccia
