#pragma once

#include <optional>

namespace breccia::parallel {

/// Sets the number of threads of OpenBLAS and returns the number before; nothing for another BLAS. A host program that
/// uses the BLAS itself restores the number after a calculation.
std::optional<int> set_blas_threads(int threads) noexcept;

}  // namespace breccia::parallel
