#include "breccia/campaign/pack.hpp"

#include "breccia/campaign/resume.hpp"
#include "breccia/homogenisation/solve_stage.hpp"
#include "breccia/results/provenance.hpp"
#include "breccia/study/soundness.hpp"

#include "checkpoints.hpp"
#include "directory_sink.hpp"
#include "first_process.hpp"
#include "result_directory.hpp"
#include "result_place.hpp"

namespace breccia {

StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                       const RunObserver& observer) {
  require_sound(study);
  const ResultPlace results(study, directory, [&] { return directory_to_pack_in(study, directory, options); });
  const auto& place = results.place();
  // An earlier run has written results of tests, which it can continue.
  const bool has_tests = holds_tests(place);
  auto how = options;
  how.resume = options.resume || has_tests;
  const Checkpoints checkpoints(study, place, how, observer);
  DirectorySink sink(study, place, checkpoints);
  StudyResult result;
  for (const auto& stage : study.stages) {
    const RemoveIfEmpty kept_stage(place / stage.name);
    pack_stage(study, stage, observer, sink, result);
    if (!has_tests) write_once([&] { write_provenance(place, study, result); });
  }
  results.commit();
  return result;
}

}  // namespace breccia
