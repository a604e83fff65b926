#include "microstructure/image/image_lines.hpp"

#include <algorithm>
#include <vector>

#include "microstructure/image/pixel_axes.hpp"

namespace breccia {

namespace {

/// The labels along one line of pixels.
struct Line {
  const std::vector<Label>& labels;
  std::size_t first, stride, length;

  [[nodiscard]] bool is_filler(std::size_t place) const { return labels[first + place * stride] != 0; }
};

/// The sums over all lines, from which the means follow.
struct Runs {
  std::size_t filler_pixels = 0, filler_runs = 0, gaps = 0, narrow_gaps = 0;

  void add(const Line& line, double narrow) {
    std::size_t begin = 0;
    while (begin < line.length) {
      const bool is_filler = line.is_filler(begin);
      auto end = begin + 1;
      while (end < line.length && line.is_filler(end) == is_filler) ++end;
      const auto length = end - begin;
      if (is_filler) {
        filler_pixels += length;
        ++filler_runs;
      } else if (begin > 0 && end < line.length) {
        ++gaps;
        if (static_cast<double>(length) < narrow) ++narrow_gaps;
      }
      begin = end;
    }
  }
};

template <int dim>
std::size_t isolated_pixels(const LabelImage<dim>& image) {
  const auto axes = pixel_axes(image.pixels);
  const auto is_alone = [&](std::size_t pixel) {
    return std::ranges::none_of(axes, [&](const PixelAxis& axis) {
      const auto place = axis.place(pixel);
      return (place > 0 && image.labels[pixel - axis.stride] == image.labels[pixel]) ||
             (place + 1 < axis.count && image.labels[pixel + axis.stride] == image.labels[pixel]);
    });
  };
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < image.labels.size(); ++pixel) {
    if (is_alone(pixel)) ++count;
  }
  return count;
}

}  // namespace

template <int dim>
Intercepts intercepts_of(const LabelImage<dim>& image, double narrow) {
  Runs runs;
  for (const auto& axis : pixel_axes(image.pixels)) {
    for (std::size_t pixel = 0; pixel < image.labels.size(); ++pixel) {
      if (axis.place(pixel) == 0) runs.add({image.labels, pixel, axis.stride, axis.count}, narrow);
    }
  }
  Intercepts made{.gaps = runs.gaps, .narrow_gaps = runs.narrow_gaps, .isolated_pixels = isolated_pixels(image)};
  if (runs.filler_runs > 0) {
    made.mean_filler = static_cast<double>(runs.filler_pixels) / static_cast<double>(runs.filler_runs);
  }
  return made;
}

template Intercepts intercepts_of(const LabelImage<2>&, double);
template Intercepts intercepts_of(const LabelImage<3>&, double);

}  // namespace breccia
