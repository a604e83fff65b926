#pragma once

#include <cstddef>
#include <optional>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// The errors of the moduli of an isotropic solid that were not tested themselves; nothing where one of those that were
/// tested is not known.
struct EngineeringErrors {
  std::optional<double> bulk = {};     ///< of K, over it [-]
  std::optional<double> young = {};    ///< of E, over it, and so of the compliance in tension [-]
  std::optional<double> poisson = {};  ///< of Poisson's ratio itself [-]
};

/// The errors that follow from the whole errors of a test in shear and of the one in bulk beside it at one of their
/// times (theory, Eq. 23i). Nothing as well where the two have other times, and where the bulk modulus is not positive.
EngineeringErrors engineering_errors(const TestResult& shear, const TestResult& bulk, std::size_t sample,
                                     int dimensions);

}  // namespace breccia
