#pragma once

#include "breccia/study/run.hpp"

#include "progress.hpp"

namespace breccia::cli {

/// Tells on a terminal what a study does, and ends it when the user asks for that.
StudyObserver narrate(Progress& progress);

}  // namespace breccia::cli
