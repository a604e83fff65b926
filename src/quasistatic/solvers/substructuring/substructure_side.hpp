#pragma once

namespace breccia {

/// Number of cells along the side of the substructures of a square on so many processes. The number of iterations does
/// not depend on the side. Larger substructures take more work, which the processes share, and have a smaller coarse
/// problem, which many processes hardly solve faster than few (docs/performance.md, "Several processes").
[[nodiscard]] constexpr int substructure_side(int processes) noexcept {
  constexpr int many = 16, very_many = 128;
  if (processes >= very_many) return 24;
  return processes >= many ? 16 : 8;
}

}  // namespace breccia
