#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace breccia {

/// Each value of a picture replaced by the median of the square of `side` x `side` pixels around it, in a stack of the
/// cube. `side` is odd. Beyond its sides the picture has the value of the nearest pixel. `extents` has the number of
/// pixels along x, y and z, 1 along z in a picture; x runs fastest.
[[nodiscard]] std::vector<std::int32_t> median_filtered(std::span<const std::int32_t> values,
                                                        const std::array<std::size_t, 3>& extents, int side);

}  // namespace breccia
