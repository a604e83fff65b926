#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/homogenisation/study_sink.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Options for solving a study.
struct SolveOptions {
  int threads = 0;             ///< number of threads; 0: all cores
  bool ignore_memory = false;  ///< start even if the study may not fit into the memory
};

/// Throws InputError where a study cannot be solved: where it is not sound (require_sound), or will not fit into the
/// memory.
void require_solvable(const Study& study, const SolveOptions& options = {});

/// Solves a study: packs its stages and runs their tests, one stage after the other, each as the matrix of the stages
/// that build on it. Everything stays in memory, except for data that a sink takes; no file is written. Throws
/// InputError as require_solvable() does, and where listed or regular particles overlap or sizes are invalid;
/// NumericalError where a random packing jams or another calculation fails; and the exceptions of the sink.
StudyResult solve(const Study& study, const SolveOptions& options = {});
StudyResult solve(const Study& study, const SolveOptions& options, StudySink& sink);
/// As solve(), but for a study for which require_solvable() has been called already: the check is not repeated.
StudyResult solve_checked(const Study& study, const SolveOptions& options, StudySink& sink);

}  // namespace breccia
