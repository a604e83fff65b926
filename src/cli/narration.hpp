#pragma once

#include "breccia/campaign/run.hpp"

#include "progress.hpp"

namespace breccia::cli {

/// Tells on a terminal what a study does, and ends it when the user asks for that.
RunObserver narrate(Progress& progress);

}  // namespace breccia::cli
