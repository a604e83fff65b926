#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia::cli {

/// The tests that a table shows; for several grids only the limit of vanishing cells, and only the mean of shears where
/// there is one.
std::vector<const TestResult*> shown_tests(const StageResult& stage);

/// The name of the modulus under a load: "G", "G, xx-yy", "K + G/3".
std::string modulus_in_words(TestLoad load, int dimensions);

/// Whether the whole error of a test is known at one time at least.
bool has_known_error(const TestResult& test);

/// The whole error of a test at its time nearest to the given one [s]: "3.4 %".
std::string error_at(const TestResult& test, double time);

/// An error in words: "3.4 %", "unknown".
std::string error_text(const std::optional<double>& error);

}  // namespace breccia::cli
