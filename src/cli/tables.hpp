#pragma once

#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

namespace breccia::cli {

/// The curves of some stages at whole decades of a window of times, a table each.
std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times);

/// The result of a study in a few lines: each curve at whole decades, beside what was measured, and what is doubtful.
std::string closing_tables(const Study& study, const StudyResult& result);

}  // namespace breccia::cli
