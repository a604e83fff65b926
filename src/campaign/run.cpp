#include "breccia/campaign/run.hpp"

#include <exception>

#include "breccia/error.hpp"

#include "campaign/directory_sink.hpp"
#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"

namespace breccia {

StudyResult run_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer) {
  ResultTransaction results(study, directory, options);
  SharedStages nothing;
  return run_study(results, observer, nothing);
}

StudyResult run_study(ResultTransaction& results, const RunObserver& observer, SharedStages& shared) {
  const auto& solve = results.options().solve;
  // This check comes before earlier results are replaced.
  require_solvable(results.study(), solve);
  results.begin_run();
  const auto &place = results.place(), &directory = results.directory();
  if (place != directory) observer.tell(ResultsKeptBeside{place});
  DirectorySink sink(results, observer, shared);
  StudyResult result;
  try {
    result = solve_checked(results.study(), solve, sink);
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
