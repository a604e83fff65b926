#include "quasistatic/solvers/lattice/wave_symbol.hpp"

#include <cmath>
#include <cstddef>

namespace breccia::quasistatic {

std::vector<HalfAngle> half_angles(int count, double step) {
  std::vector<HalfAngle> angles(static_cast<std::size_t>(count));
  for (std::size_t wave = 0; wave < angles.size(); ++wave) {
    const double half = 0.5 * step * static_cast<double>(wave);
    angles[wave] = {std::sin(half), std::cos(half)};
  }
  return angles;
}

}  // namespace breccia::quasistatic
