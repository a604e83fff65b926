#pragma once

#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/study/tests.hpp"

namespace breccia::cli {

/// A table for each stage with its curves at whole decades within a window of times [s], or of its complex moduli at
/// whole decades of hertz.
std::string tables_of(const std::vector<StageResult>& stages, const TimeWindow& times, Abscissa abscissa);

/// The result of a study in a few lines: each curve at whole decades, comparisons with measurements, and warnings.
std::string closing_tables(const Study& study, const StudyResult& result);

}  // namespace breccia::cli
