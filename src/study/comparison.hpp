#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/run.hpp"

namespace breccia {

/// G(t) of a stage under all boundaries and by all methods beside each measurement of it, over the times that both
/// tell.
std::vector<Comparison> compare(const Study& study, const Stage& stage, const std::vector<TestResult>& tests);

/// Writes `comparison.csv` if there is something to compare.
void write_comparisons(const std::filesystem::path& directory, const StudyResult& result);

}  // namespace breccia
