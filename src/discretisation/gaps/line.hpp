#pragma once

#include <array>
#include <cstddef>

#include "breccia/microstructure/vector.hpp"

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side.

/// A piece of a line, from one place on it to another.
struct Interval {
  double begin, end;
  [[nodiscard]] double length() const noexcept { return end - begin; }
};

/// A line along an axis, on which places are measured from an origin.
template <int dim>
struct GridLine {
  Vector<dim> origin;
  std::size_t axis;

  [[nodiscard]] Vector<dim> at(double place) const noexcept {
    auto point = origin;
    point[axis] += place;
    return point;
  }
};

/// The unit vector along a vector; zero for a vector of rounding errors.
template <std::size_t dim>
[[nodiscard]] std::array<double, dim> direction(const std::array<double, dim>& vector) noexcept {
  constexpr double least = 1e-12;
  const double length = norm(vector);
  return length > least ? vector / length : std::array<double, dim>{};
}

}  // namespace breccia::gaps
