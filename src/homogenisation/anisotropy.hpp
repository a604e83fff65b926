#pragma once

#include <optional>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// How far the shears of a box are apart at one time, whose mean is its shear modulus.
struct AnisotropyAtTime {
  double time = 0.0;      ///< [s]
  double distance = 0.0;  ///< largest modulus of a shear over the smallest, minus 1 [-]
};

/// The anisotropy of a box at the first and the last time of its curves.
struct Anisotropy {
  AnisotropyAtTime first, last;
};

/// The anisotropy from the preferred tests of a stage of so many dimensions, the largest of all boundaries and methods;
/// nothing where the tests have no isotropic mean, or where a modulus has fallen to zero.
std::optional<Anisotropy> anisotropy_of_tests(int dimensions, const std::vector<TestResult>& tests);

}  // namespace breccia
