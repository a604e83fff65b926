#pragma once

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Whether a test in shear and one in bulk give the moduli of one solid: under the same boundary, by the same method,
/// on the same grid, and with series that are known.
bool are_of_one_solid(const TestResult& shear, const TestResult& bulk);

}  // namespace breccia
