#pragma once

#include <string>

#include "breccia/assessment/assess.hpp"
#include "breccia/study/tests.hpp"

namespace breccia::cli {

/// The uncertain inputs of an assessment, a line each, with what is known of them.
std::string table_of_inputs(const std::vector<UncertainInput>& inputs, const std::vector<bool>& change_the_box);

/// A curve of an assessment, a line a decade: its median, its intervals and the shares of the inputs in its variance.
std::string table_of_curve(const AssessedCurve& curve, const std::vector<UncertainInput>& inputs, Abscissa abscissa);

}  // namespace breccia::cli
