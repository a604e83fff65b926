#pragma once

#include <string>
#include <vector>

#include "breccia/study/run.hpp"

#include "progress.hpp"

namespace breccia::cli {

/// Tells on a terminal what a study does, and ends it when the user asks for that.
StudyObserver narrate(Progress& progress);

/// The curves of some stages at whole decades of a window of times.
std::string table_of(const std::vector<StageResult>& stages, const TimeWindow& times);

/// The result of a study in a few lines: each curve at whole decades.
std::string closing_table(const Study& study, const StudyResult& result);

}  // namespace breccia::cli
