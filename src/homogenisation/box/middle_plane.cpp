#include "homogenisation/box/middle_plane.hpp"

#include "homogenisation/box/stage_labelling.hpp"

namespace breccia {
namespace {

LabelImage<2> middle_plane(const Stage& stage, const Labelling<3>& labelling, std::size_t normal) {
  constexpr int pixels = 500;
  const std::size_t across = (normal + 1) % 3, up = (normal + 2) % 3;
  LabelImage<2> plane = {.pixels = {pixels, pixels},
                         .pixel_side = stage.side / pixels,
                         .walls = stage.is_periodic() ? Walls::periodic : Walls::hard,
                         .labels = {}};
  Vector<3> place{};
  place[normal] = 0.5 * stage.side;
  for (int row = 0; row < pixels; ++row) {
    place[up] = (row + 0.5) * plane.pixel_side;
    for (int column = 0; column < pixels; ++column) {
      place[across] = (column + 0.5) * plane.pixel_side;
      plane.labels.push_back(labelling(place).phase);
    }
  }
  return plane;
}

}  // namespace

LabelImage<2> middle_plane(const Stage& stage, const EllipsoidBox& ellipsoids, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, ellipsoids), normal);
}

LabelImage<2> middle_plane(const Stage& stage, const Grains<3>& grains, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, grains), normal);
}

LabelImage<2> middle_plane(const Stage& stage, const SharedImage<3>& image, std::size_t normal) {
  return middle_plane(stage, labelling_of(stage, image), normal);
}

}  // namespace breccia
