#pragma once

#include "breccia/homogenisation/study_observer.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/homogenisation/study_sink.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The steps of solve(), for a caller that decides stage by stage what is to be computed. The study must be sound
/// (require_sound).

/// Packs one stage of a study and adds it to the result, without tests. Throws as solve() does.
void pack_stage(const Study& study, const Stage& stage, const StudyObserver& observer, StudySink& sink,
                StudyResult& result);

/// Runs all tests of the stage that was added to the result last, and what follows from them: extrapolation, the
/// material that later stages build on, the comparison with measurements. `threads` is 0 for all. Throws as solve()
/// does, and InputError where the last stage of the result is another one.
void test_stage(const Study& study, const Stage& stage, int threads, const StudyObserver& observer, StudySink& sink,
                StudyResult& result);

}  // namespace breccia
