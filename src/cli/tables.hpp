#pragma once

#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

namespace breccia::cli {

/// A table for each stage with its curves at whole decades within a window of times [s].
std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times);

/// The result of a study in a few lines: each curve at whole decades, comparisons with measurements, and warnings.
std::string closing_tables(const Study& study, const StudyResult& result);

}  // namespace breccia::cli
