#include "breccia/microstructure/cubic_lattice.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// Places in the conventional cube, in units of its side. No ball is cut by a side of the box more often than needed.
std::vector<Vector<3>> basis_of(Lattice lattice) {
  switch (lattice) {
    case Lattice::simple:
      return {{0.5, 0.5, 0.5}};
    case Lattice::body_centred:
      return {{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}};
    case Lattice::face_centred:
      return {{0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
  }
  return {};
}

}  // namespace

double nearest_distance(Lattice lattice) noexcept {
  switch (lattice) {
    case Lattice::body_centred:
      return 0.5 * std::sqrt(3.0);
    case Lattice::face_centred:
      return std::sqrt(0.5);
    default:
      return 1.0;
  }
}

Microstructure<3> cubic_array(double side, Lattice lattice, int repeats, double diameter) {
  if (!(side > 0.0) || repeats < 1 || !(diameter > 0.0)) {
    throw InputError("a cubic lattice: expected a positive side, number of repeats and diameter");
  }
  const double cube = side / repeats, nearest = nearest_distance(lattice) * cube;
  constexpr double rounding = 1e-12;
  if (diameter > nearest * (1.0 + rounding)) {
    throw InputError(fmt::format("balls of {} m overlap on a lattice whose nearest places are {} m apart", diameter,
                                 nearest));
  }
  Microstructure<3> box = {side, Walls::periodic, {}};
  for_each_index(Index<3>{}, Index<3>{repeats, repeats, repeats}, [&](const Index<3>& place) {
    for (const auto& offset : basis_of(lattice)) {
      Vector<3> centre{};
      for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = (place[axis] + offset[axis]) * cube;
      box.particles.push_back({centre, diameter});
    }
  });
  return box;
}

}  // namespace breccia
