#include "breccia/homogenisation/solve.hpp"

#include <chrono>

#include "breccia/homogenisation/available_memory.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/solve_stage.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/study/soundness.hpp"

namespace breccia {

StudyResult solve(const Study& study, const SolveOptions& options, const StudyObserver& observer) {
  StudySink nothing_is_kept;
  return solve(study, options, observer, nothing_is_kept);
}

StudyResult solve(const Study& study, const SolveOptions& options, const StudyObserver& observer, StudySink& sink) {
  const auto begin = std::chrono::steady_clock::now();
  require_sound(study);
  if (!options.ignore_memory && parallel::is_alone()) require_memory(study, available_memory());
  StudyResult result;
  for (const auto& stage : study.stages) {
    pack_stage(study, stage, observer, sink, result);
    test_stage(study, stage, options.threads, observer, sink, result);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace breccia
