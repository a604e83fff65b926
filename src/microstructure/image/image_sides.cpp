#include "microstructure/image/image_sides.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "microstructure/image/pixel_axes.hpp"

namespace breccia {

namespace {

/// The share of the pixels of each layer across an axis whose label differs from that of their neighbour in the next
/// layer; behind the last layer the first one comes.
template <int dim>
std::vector<double> differing_shares(const LabelImage<dim>& image, const PixelAxis& axis) {
  std::vector<std::size_t> differing(axis.count);
  for (std::size_t pixel = 0; pixel < image.labels.size(); ++pixel) {
    const auto place = axis.place(pixel);
    const auto next = place + 1 < axis.count ? pixel + axis.stride : pixel - place * axis.stride;
    if (image.labels[pixel] != image.labels[next]) ++differing[place];
  }
  std::vector<double> shares;
  shares.reserve(differing.size());
  for (const auto count : differing) {
    shares.push_back(static_cast<double>(count * axis.count) / static_cast<double>(image.labels.size()));
  }
  return shares;
}

/// The number of layers of one value before the first other one; 0 if there is none of these.
std::size_t constant_layers(std::span<const char> is_constant) {
  const auto first = std::ranges::find(is_constant, 0);
  return first == is_constant.end() ? 0 : static_cast<std::size_t>(first - is_constant.begin());
}

}  // namespace

template <int dim>
double cut_share(const LabelImage<dim>& image) {
  const auto axes = pixel_axes(image.pixels);
  std::vector<bool> is_cut(image.labels.size());
  std::vector<std::size_t> rest;
  const auto reach = [&](std::size_t pixel) {
    if (is_cut[pixel]) return;
    is_cut[pixel] = true;
    rest.push_back(pixel);
  };
  const auto is_at_side = [&](std::size_t pixel) {
    return std::ranges::any_of(axes, [pixel](const PixelAxis& axis) {
      const auto place = axis.place(pixel);
      return place == 0 || place + 1 == axis.count;
    });
  };
  std::size_t filler = 0, cut = 0;
  for (std::size_t pixel = 0; pixel < image.labels.size(); ++pixel) {
    if (image.labels[pixel] == 0) continue;
    ++filler;
    if (is_at_side(pixel)) reach(pixel);
  }
  while (!rest.empty()) {
    const auto pixel = rest.back();
    rest.pop_back();
    ++cut;
    for (const auto& axis : axes) {
      const auto place = axis.place(pixel);
      const auto reach_same = [&](std::size_t next) {
        if (image.labels[next] == image.labels[pixel]) reach(next);
      };
      if (place > 0) reach_same(pixel - axis.stride);
      if (place + 1 < axis.count) reach_same(pixel + axis.stride);
    }
  }
  return filler == 0 ? 0.0 : static_cast<double>(cut) / static_cast<double>(filler);
}

template <int dim>
Seam seam_of(const LabelImage<dim>& image) {
  std::vector<Seam> seams;
  for (const auto& axis : pixel_axes(image.pixels)) {
    auto shares = differing_shares(image, axis);
    const double across = shares.back();
    shares.pop_back();
    seams.push_back({across, shares.empty() ? 0.0 : std::ranges::max(shares)});
  }
  return std::ranges::max(seams, {}, [](const Seam& seam) { return seam.across - seam.most_inside; });
}

std::size_t frame_of(std::span<const std::int32_t> values, std::span<const std::size_t> extents) {
  std::size_t frame = 0;
  for (const auto& axis : pixel_axes(extents)) {
    std::vector<std::optional<std::int32_t>> value(axis.count);
    std::vector<char> is_constant(axis.count, 1);
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
      const auto layer = axis.place(pixel);
      if (!value[layer]) value[layer] = values[pixel];
      if (values[pixel] != *value[layer]) is_constant[layer] = 0;
    }
    const auto before = constant_layers(is_constant);
    std::ranges::reverse(is_constant);
    frame = std::max({frame, before, constant_layers(is_constant)});
  }
  return frame;
}

template double cut_share(const LabelImage<2>&);
template double cut_share(const LabelImage<3>&);
template Seam seam_of(const LabelImage<2>&);
template Seam seam_of(const LabelImage<3>&);

}  // namespace breccia
