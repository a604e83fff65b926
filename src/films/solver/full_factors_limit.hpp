#pragma once

#include <cstdint>

namespace breccia::films {

/// The number of unknowns of films in space from which on compressed factors are the faster ones (docs/performance.md).
/// It does not depend on the machine, because the last digits of the solvers differ.
inline constexpr std::int64_t full_factors_in_space = 150'000;

}  // namespace breccia::films
