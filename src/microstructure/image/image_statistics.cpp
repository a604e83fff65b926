#include "microstructure/image/image_statistics.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

template <int dim>
std::vector<double> label_fractions(const LabelImage<dim>& image, std::size_t count) {
  std::vector<std::size_t> pixels(count);
  for (const auto label : image.labels) {
    if (label >= count) {
      throw InputError(
          fmt::format("image: a pixel has the label {}, counted from 0, but there are only {}", label, count));
    }
    ++pixels[label];
  }
  std::vector<double> fractions;
  fractions.reserve(count);
  for (const auto of_label : pixels) {
    fractions.push_back(static_cast<double>(of_label) / static_cast<double>(image.labels.size()));
  }
  return fractions;
}

namespace {

/// Sides between pixels of different labels along one axis.
template <int dim>
std::size_t sides_along(const LabelImage<dim>& image, std::size_t axis) {
  std::size_t stride = 1;
  for (std::size_t lower = 0; lower < axis; ++lower) stride *= static_cast<std::size_t>(image.pixels[lower]);
  const auto along = static_cast<std::size_t>(image.pixels[axis]);
  const bool is_periodic = image.walls == Walls::periodic;
  std::size_t sides = 0;
  for (std::size_t pixel = 0; pixel < image.labels.size(); ++pixel) {
    const bool is_last = pixel / stride % along + 1 == along;
    if (is_last && !is_periodic) continue;
    const auto next = is_last ? pixel - (along - 1) * stride : pixel + stride;
    if (image.labels[pixel] != image.labels[next]) ++sides;
  }
  return sides;
}

}  // namespace

template <int dim>
double specific_interface(const LabelImage<dim>& image) {
  std::size_t sides = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) sides += sides_along(image, axis);
  return static_cast<double>(sides) / (static_cast<double>(image.labels.size()) * image.pixel_side);
}

template std::vector<double> label_fractions(const LabelImage<2>&, std::size_t);
template std::vector<double> label_fractions(const LabelImage<3>&, std::size_t);
template double specific_interface(const LabelImage<2>&);
template double specific_interface(const LabelImage<3>&);

}  // namespace breccia
