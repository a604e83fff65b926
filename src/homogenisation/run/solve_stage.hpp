#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/homogenisation/study_sink.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The steps of solve(), for callers that decide for each stage whether to compute it. The study must be sound
/// (require_sound).

/// Packs one stage of a study and adds it to the result, without tests. Throws as solve() does.
void pack_stage(const Study& study, const Stage& stage, StudySink& sink, StudyResult& result);

/// Runs all tests of the last stage of the result, then the extrapolation, the fit of its material for later stages and
/// the comparison with measurements. `threads` = 0 means all cores. Throws as solve(), and InputError if the last stage
/// of the result is another one.
void test_stage(const Study& study, const Stage& stage, int threads, StudySink& sink, StudyResult& result);

}  // namespace breccia
