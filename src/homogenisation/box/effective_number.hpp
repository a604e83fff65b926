#pragma once

#include <span>

namespace breccia {

/// The square of the sum of volumes over the sum of their squares [-]: their number where they are equal, less where
/// some are far larger than others (theory, Eq. 43h). 0 without any.
double effective_number(std::span<const double> volumes);

}  // namespace breccia
