#pragma once

#include <string>

#include "breccia/assessment/assess.hpp"
#include "breccia/study/tests.hpp"

namespace breccia::cli {

/// What is known of an input in words: "1, within a factor 2", "any of 1, 2".
std::string in_words(const UncertainInput& input);

/// The uncertain inputs of an assessment, a line each, with what is known of them.
std::string table_of_inputs(const std::vector<UncertainInput>& inputs, const std::vector<bool>& change_the_box);

/// A curve of an assessment, a line a decade: its median, its intervals and the shares of the inputs in its variance.
std::string table_of_curve(const AssessedCurve& curve, const std::vector<UncertainInput>& inputs, Abscissa abscissa);

}  // namespace breccia::cli
