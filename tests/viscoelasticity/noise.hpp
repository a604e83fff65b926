#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace breccia {

/// Multiplies numbers by 1 plus a normal deviate (Box and Muller), which is the same with every library.
class Noise {
 public:
  explicit Noise(double deviation, std::uint64_t seed = 7) : random_(seed), deviation_(deviation) {}
  double operator()(double value) {
    constexpr double two_pi = 6.283185307179586;
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return value * (1.0 + deviation_ * radius * std::cos(two_pi * uniform()));
  }

 private:
  double uniform() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 random_;
  double deviation_;
};

}  // namespace breccia
