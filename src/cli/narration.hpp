#pragma once

#include "breccia/campaign/run.hpp"

#include "cli/detail.hpp"
#include "cli/progress_line.hpp"

namespace breccia::cli {

/// An observer that prints the progress and the events of a study or a sweep, and ends a sweep before its next task
/// when the user interrupts it. The line must outlive the observer.
RunObserver narrate(ProgressLine& line, Detail detail);

}  // namespace breccia::cli
