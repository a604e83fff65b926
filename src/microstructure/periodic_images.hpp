#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// A periodic box and its copies that touch it, 3^dim in all. An image is a number whose digits in base 3 are, axis by
/// axis, 0 for a copy one side below, 1 for the box itself and 2 for a copy one side above.
template <int dim>
class PeriodicImages {
 public:
  using Image = std::uint32_t;
  static constexpr Image count = [] {
    Image images = 1;
    for (int axis = 0; axis < dim; ++axis) images *= 3;
    return images;
  }();
  static constexpr Image in_place = (count - 1) / 2;
  [[nodiscard]] static constexpr Image opposite(Image image) noexcept { return count - 1 - image; }

  explicit PeriodicImages(double side) {
    for (Image image = 0; image < count; ++image) {
      const auto displaced_by = sides(image);
      for (std::size_t axis = 0; axis < dim; ++axis) shifts_[image][axis] = displaced_by[axis] * side;
    }
  }

  /// Displacement of an image along each axis, in sides of the box: -1, 0 or 1.
  [[nodiscard]] static constexpr Index<dim> sides(Image image) noexcept {
    Index<dim> displaced_by{};
    for (int& along_axis : displaced_by) {
      along_axis = static_cast<int>(image % 3) - 1;
      image /= 3;
    }
    return displaced_by;
  }

  /// Displacement from a point to its image [m].
  [[nodiscard]] const Vector<dim>& shift(Image image) const noexcept { return shifts_[image]; }

 private:
  std::array<Vector<dim>, count> shifts_;
};

/// The coordinate of the image inside [0, side).
[[nodiscard]] inline double wrapped(double coordinate, double side) noexcept {
  const double inside = coordinate - side * std::floor(coordinate / side);
  return inside < side ? inside : 0.0;
}

}  // namespace breccia
