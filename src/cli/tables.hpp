#pragma once

#include <string>

#include "breccia/campaign/run.hpp"
#include "breccia/study/tests.hpp"

#include "cli/detail.hpp"

namespace breccia::cli {

/// A table of the curves of a stage at whole decades within a window of times [s], or tables of its complex moduli at
/// whole decades of hertz.
std::string tables_of(const StageResult& stage, const TimeWindow& times, Abscissa abscissa);

/// The result of a study in a few lines: each curve at whole decades, its error, and comparisons with measurements; in
/// brief those of the stages that no other stage builds upon.
std::string closing_tables(const Study& study, const StudyResult& result, Detail detail);

}  // namespace breccia::cli
