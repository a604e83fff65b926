#pragma once

#include "breccia/campaign/run.hpp"

#include "progress.hpp"

namespace breccia::cli {

/// An observer that prints the progress of a study, and ends the study when the user interrupts it.
RunObserver narrate(Progress& progress);

}  // namespace breccia::cli
