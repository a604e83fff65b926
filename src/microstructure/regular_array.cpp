#include "microstructure/regular_array.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

template <int dim>
Microstructure<dim> regular_array(double side, const Index<dim>& counts, double diameter, Walls walls) {
  if (!(side > 0.0) || !std::isfinite(side)) {
    throw InputError(fmt::format("regular array: the side of the box must be positive, got {} m", side));
  }
  if (std::ranges::min(counts) < 1) {
    throw InputError(
        fmt::format("regular array: needs at least one particle along each axis, got {}", fmt::join(counts, " x ")));
  }
  Vector<dim> spacing{};
  std::ranges::transform(counts, spacing.begin(), [side](int count) { return side / count; });
  const double closest = std::ranges::min(spacing);
  if (!(diameter > 0.0) || !(diameter < closest)) {
    throw InputError(
        fmt::format("regular array: {} particles in a box of side {} m must have a positive diameter below {} m, or "
                    "they touch; got {} m",
                    fmt::join(counts, " x "), side, closest, diameter));
  }
  Microstructure<dim> microstructure{side, walls, {}};
  for_each_index(Index<dim>{}, counts, [&](const Index<dim>& index) {
    Vector<dim> centre{};
    for (std::size_t axis = 0; axis < centre.size(); ++axis) centre[axis] = (index[axis] + 0.5) * spacing[axis];
    microstructure.particles.push_back({centre, diameter});
  });
  return microstructure;
}

template Microstructure<2> regular_array<2>(double, const Index<2>&, double, Walls);
template Microstructure<3> regular_array<3>(double, const Index<3>&, double, Walls);

}  // namespace breccia
