#pragma once

#include <random>

namespace breccia {

/// A random number, uniform in [0, 1), which is the same on every platform.
[[nodiscard]] inline double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

}  // namespace breccia
