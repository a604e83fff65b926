#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/tests.hpp"

namespace breccia::cli {

/// Tables of the ratios of the computed moduli to each measurement of each stage: of G(t) at whole decades, or of the
/// complex modulus at the measured frequencies, a dozen of them. What has no complex modulus is compared in time.
std::string comparison_tables_of(const std::vector<StageResult>& stages, Abscissa abscissa);

}  // namespace breccia::cli
