#pragma once

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
struct GridLine {
  Vector<2> origin;
  std::size_t axis;

  [[nodiscard]] Vector<2> at(double place) const noexcept {
    auto point = origin;
    point[axis] += place;
    return point;
  }
};

/// The unit vector along a vector; zero for a vector of rounding errors.
[[nodiscard]] inline Vector<2> direction(const Vector<2>& vector) noexcept {
  constexpr double least = 1e-12;
  const double length = norm(vector);
  return length > least ? vector / length : Vector<2>{};
}

}  // namespace breccia::gaps
