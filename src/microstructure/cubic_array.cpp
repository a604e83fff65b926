#include "breccia/microstructure/cubic_array.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// Centres of the spheres of a cell of side 1.
std::vector<Vector<3>> centres_of(Lattice lattice) {
  switch (lattice) {
    case Lattice::body_centred:
      return {{0.5, 0.5, 0.5}, {0.0, 0.0, 0.0}};
    case Lattice::face_centred:
      return {{0.5, 0.5, 0.5}, {0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.5}};
    case Lattice::simple:
      break;
  }
  return {{0.5, 0.5, 0.5}};
}

void require_box(double side, int repeats) {
  if (!(side > 0.0) || !std::isfinite(side)) {
    throw InputError(fmt::format("cubic array: the side of the box must be positive, got {} m", side));
  }
  if (repeats < 1) {
    throw InputError(fmt::format("cubic array: expected at least one cell along each axis, got {}", repeats));
  }
}

}  // namespace

double nearest_distance(Lattice lattice) {
  switch (lattice) {
    case Lattice::body_centred:
      return 0.5 * std::numbers::sqrt3;
    case Lattice::face_centred:
      return std::sqrt(0.5);
    case Lattice::simple:
      break;
  }
  return 1.0;
}

Microstructure<3> cubic_array(Lattice lattice, double side, int repeats, double diameter) {
  require_box(side, repeats);
  const double cell = side / repeats;
  const double closest = nearest_distance(lattice) * cell;
  if (!(diameter > 0.0) || !(diameter < closest)) {
    throw InputError(
        fmt::format("cubic array: spheres on a lattice {} of {} cells along each side of {} m must have a positive "
                    "diameter below {:.6g} m, or they touch; got {:.6g} m",
                    name_of(lattice), repeats, side, closest, diameter));
  }
  Microstructure<3> array{side, Walls::periodic, {}};
  for_each_index(Index<3>{}, Index<3>{repeats, repeats, repeats}, [&](const Index<3>& index) {
    for (auto centre : centres_of(lattice)) {
      for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = (index[axis] + centre[axis]) * cell;
      array.particles.push_back({centre, diameter});
    }
  });
  return array;
}

double cubic_array_diameter(Lattice lattice, double side, int repeats, double fraction) {
  require_box(side, repeats);
  const double cell = side / repeats;
  const auto spheres = static_cast<double>(centres_of(lattice).size());
  const double closest = nearest_distance(lattice);
  const double densest = spheres * ball_volume<3>(closest);
  if (!(fraction > 0.0) || !(fraction < densest)) {
    throw InputError(
        fmt::format("cubic array: spheres on a lattice {} must fill a fraction above 0 and below {:.4f}, or they "
                    "touch; got {}",
                    name_of(lattice), densest, fraction));
  }
  return cell * std::cbrt(fraction / (spheres * ball_volume<3>(1.0)));
}

}  // namespace breccia
