#include "breccia/homogenisation/solve.hpp"

#include <chrono>
#include <utility>

#include "breccia/homogenisation/plan.hpp"
#include "breccia/study/soundness.hpp"

#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/modulus_errors.hpp"
#include "homogenisation/quality.hpp"
#include "homogenisation/run/comparison.hpp"
#include "homogenisation/run/solve_stage.hpp"
#include "homogenisation/run/stage_expansions.hpp"
#include "parallel/available_memory.hpp"
#include "parallel/session.hpp"
#include "study/chain.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

/// Adds a stage to the result: the stage as the sink knows it, or else as it is computed.
void solve_stage(const Study& study, const Stage& stage, int threads, StudySink& sink, StudyResult& result) {
  if (auto known = sink.known_stage(stage)) {
    add_errors(*known, error_rules_of(study, stage, known->microstructure), stage.matrix, result.stages);
    if (study.tests.by_frequency) add_complex_moduli(known->tests, study.tests.points_per_decade);
    known->comparisons = compare(study.measurements, *known, shear_of_material(study.tests));
    add_expansions(study, stage, result.stages, *known);
    known->accuracy = accuracy_of(quality_of(study, stage, *known));
    result.stages.push_back(std::move(*known));
    sink.happened(StageAdopted{stage, result});
    return;
  }
  pack_stage(study, stage, sink, result);
  test_stage(study, stage, threads, sink, result);
}

}  // namespace

void require_solvable(const Study& study, const SolveOptions& options) {
  require_sound(study);
  if (!options.ignore_memory && parallel::is_alone()) require_memory(study, parallel::available_memory());
}

StudyResult solve(const Study& study, const SolveOptions& options) {
  StudySink nothing_is_kept;
  return solve(study, options, nothing_is_kept);
}

StudyResult solve(const Study& study, const SolveOptions& options, StudySink& sink) {
  require_solvable(study, options);
  return solve_checked(study, options, sink);
}

StudyResult solve_checked(const Study& study, const SolveOptions& options, StudySink& sink) {
  const auto begin = std::chrono::steady_clock::now();
  StudyResult result;
  result.study_hash = provenance_of(study).hash;
  for (const auto& stage : study.stages) solve_stage(study, stage, options.threads, sink, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  sink.happened(StudyFinished{result});
  return result;
}

}  // namespace breccia
