#pragma once

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The result of a stage that is packed and not tested yet.
StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure);

}  // namespace breccia
