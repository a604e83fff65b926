#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia::cli {

/// Tables of the complex moduli of a stage at whole decades of hertz: for each test, and Young's modulus where shear
/// and bulk were tested. The error of a modulus is the one at the time of its angular frequency, 1 / omega.
std::string frequency_table_of(const StageResult& stage);

}  // namespace breccia::cli
