#pragma once

#include <cstddef>
#include <vector>

namespace breccia {

/// The order of the pixels of a picture along one of its axes.
struct PixelAxis {
  std::size_t stride;  ///< from a pixel to the next one
  std::size_t count;   ///< number of pixels

  [[nodiscard]] std::size_t place(std::size_t pixel) const { return pixel / stride % count; }
};

/// The axes of a picture with these numbers of pixels along x, y and, in a stack, z, of which x runs fastest.
template <class Extents>
std::vector<PixelAxis> pixel_axes(const Extents& extents) {
  std::vector<PixelAxis> axes;
  std::size_t stride = 1;
  for (const auto extent : extents) {
    axes.push_back({stride, static_cast<std::size_t>(extent)});
    stride *= static_cast<std::size_t>(extent);
  }
  return axes;
}

}  // namespace breccia
