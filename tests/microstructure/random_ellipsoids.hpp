#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "breccia/microstructure/ellipsoid.hpp"

namespace breccia::test {

/// A random number, uniform between two numbers, which is the same on every platform.
inline double uniform_between(std::mt19937_64& engine, double low, double high) {
  return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

inline Vector<3> random_direction(std::mt19937_64& engine) {
  const double z = uniform_between(engine, -1.0, 1.0), angle = uniform_between(engine, 0.0, 2.0 * std::numbers::pi);
  const double radius = std::sqrt((1.0 - z) * (1.0 + z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// A random ellipsoid near the origin, with axes from 0.2 to 2 and any orientation.
inline Ellipsoid random_ellipsoid(std::mt19937_64& engine) {
  Ellipsoid ellipsoid{};
  for (double& x : ellipsoid.centre) x = uniform_between(engine, -1.5, 1.5);
  for (double& axis : ellipsoid.axes) axis = uniform_between(engine, 0.2, 2.0);
  ellipsoid.directions = turned({uniform_between(engine, 0.1, 1.0), uniform_between(engine, -1.0, 1.0),
                                 uniform_between(engine, -1.0, 1.0), uniform_between(engine, -1.0, 1.0)});
  return ellipsoid;
}

}  // namespace breccia::test
