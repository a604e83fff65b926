#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The result of a stage that has its microstructure and its warnings, but no tests yet.
StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure);

/// As packed_stage(), but all processes of the group, each of which must call the function, count the points of the
/// fillers together.
StageResult packed_stage_together(const Study& study, const Stage& stage, StageMicrostructure microstructure);

}  // namespace breccia
