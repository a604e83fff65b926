#include "breccia/microstructure/label_image.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

/// The index of the pixel at a coordinate, in pixels, along an axis of `count` pixels.
int pixel_at(double coordinate, int count, Walls walls) {
  if (walls == Walls::periodic) coordinate -= count * std::floor(coordinate / count);
  return static_cast<int>(std::clamp(std::floor(coordinate), 0.0, count - 1.0));
}

}  // namespace

template <int dim>
Label LabelImage<dim>::label_at(const Vector<dim>& point) const noexcept {
  std::size_t index = 0;
  for (std::size_t axis = dim; axis-- > 0;) {
    const auto count = pixels[axis];
    index = index * static_cast<std::size_t>(count) +
            static_cast<std::size_t>(pixel_at(point[axis] / pixel_side, count, walls));
  }
  return labels[index];
}

template <int dim>
Vector<dim> box_of(const LabelImage<dim>& image) {
  Vector<dim> sides;
  std::ranges::transform(image.pixels, sides.begin(), [&](int count) { return count * image.pixel_side; });
  return sides;
}

template <int dim>
bool has_equal_sides(const LabelImage<dim>& image) {
  return std::ranges::count(image.pixels, image.pixels.front()) == dim;
}

template <int dim>
void require_valid(const LabelImage<dim>& image) {
  std::size_t count = 1;
  for (const int along_axis : image.pixels) count *= static_cast<std::size_t>(std::max(along_axis, 0));
  if (count == 0) {
    throw InputError(
        fmt::format("image: {} pixels; expected at least one along each axis", fmt::join(image.pixels, " x ")));
  }
  if (!(image.pixel_side > 0.0) || !std::isfinite(image.pixel_side)) {
    throw InputError(fmt::format("image: the side of a pixel must be positive, got {} m", image.pixel_side));
  }
  if (image.labels.size() != count) {
    throw InputError(fmt::format("image: {} labels; expected {} for {} pixels", image.labels.size(), count,
                                 fmt::join(image.pixels, " x ")));
  }
}

template struct LabelImage<2>;
template struct LabelImage<3>;
template Vector<2> box_of(const LabelImage<2>&);
template Vector<3> box_of(const LabelImage<3>&);
template bool has_equal_sides(const LabelImage<2>&);
template bool has_equal_sides(const LabelImage<3>&);
template void require_valid(const LabelImage<2>&);
template void require_valid(const LabelImage<3>&);

}  // namespace breccia
