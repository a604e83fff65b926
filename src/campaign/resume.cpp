#include "breccia/campaign/resume.hpp"

#include "breccia/io/replacement.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/results/report.hpp"
#include "breccia/results/study_record.hpp"

#include "checkpoints.hpp"
#include "result_directory.hpp"

namespace breccia {

std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory) {
  const auto record = read_study_record(directory);
  return record.is_complete_run_of(study) ? record.wall_time : std::nullopt;
}

std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory) {
  if (parallel::is_first()) finish_interrupted_replacement(study, directory);
  // Nobody looks before the files are in their places.
  static_cast<void>(parallel::gather({}));
  const auto seconds = time_of_complete_run(study, directory);
  if (!seconds || !parallel::is_first()) return seconds;
  remove_partial_files(study, directory);
  if (remove_checkpoints(study, directory)) write_study_report(directory);
  return seconds;
}

bool holds_tests(const std::filesystem::path& directory) {
  return read_study_record(directory).has_tests;
}

}  // namespace breccia
