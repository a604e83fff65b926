#pragma once

#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

#include "cli/detail.hpp"

namespace breccia::cli {

/// A table for each stage with its curves at whole decades within a window of times [s].
std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times);

/// The result of a study in a few lines: each curve at whole decades, its error, and comparisons with measurements; in
/// brief those of the stages that no other stage builds upon.
std::string closing_tables(const Study& study, const StudyResult& result, Detail detail);

}  // namespace breccia::cli
