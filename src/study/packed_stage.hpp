#pragma once

#include "breccia/study/run.hpp"

namespace breccia {

/// The result of a stage that is packed and not tested yet.
StageResult packed_stage(const Study& study, const Stage& stage, StageMicrostructure microstructure);

}  // namespace breccia
