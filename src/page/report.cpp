#include "page/report.hpp"

#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/directory_lock.hpp"
#include "io/replacement.hpp"
#include "page/study_report.hpp"
#include "page/sweep_report.hpp"
#include "results/study_record.hpp"

namespace breccia {

void write_report(const std::filesystem::path& directory) {
  const bool has_study = std::filesystem::is_regular_file(directory / "study.json");
  const auto sweep = directory / "sweep.json";
  // Next to the results of a study, such a file may be one of the user's own.
  const bool is_sweep = has_study ? is_record_of_breccia(sweep) : std::filesystem::is_regular_file(sweep);
  if (!is_sweep && !has_study) {
    throw InputError(fmt::format("{}: no study.json or sweep.json, which `breccia run` leaves with its results",
                                 directory.string()));
  }
  std::optional<DirectoryLock> lock_of_run;
  if (const auto results = results_with_unfinished(directory)) lock_of_run.emplace(*results);
  const DirectoryLock lock(directory);
  if (is_sweep) {
    write_sweep_report(directory);
  } else {
    write_study_report(directory);
  }
}

}  // namespace breccia
