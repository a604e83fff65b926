#include "breccia/campaign/run.hpp"

#include <exception>

#include "breccia/error.hpp"

#include "campaign/directory_sink.hpp"
#include "campaign/result_directory.hpp"
#include "campaign/result_place.hpp"
#include "campaign/shared_stages.hpp"

namespace breccia {

StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer) {
  SharedStages nothing;
  return run_study(study, directory, options, observer, nothing);
}

StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer, SharedStages& shared) {
  // This check comes before earlier results are replaced.
  require_solvable(study, options.solve);
  const ResultPlace results(study, directory, [&] { return directory_to_run_in(study, directory, options); });
  const auto& place = results.place();
  if (place != directory) observer.tell(ResultsKeptBeside{place});
  DirectorySink sink(study, place, options, observer, shared);
  StudyResult result;
  try {
    result = solve_checked(study, options.solve, sink);
  } catch (const NumericalError&) {
    sink.keep_failure(std::current_exception());
    throw;
  } catch (const InputError&) {
    sink.keep_failure(std::current_exception());
    throw;
  }
  results.commit();
  shared.move_files(place, directory);
  return result;
}

}  // namespace breccia
