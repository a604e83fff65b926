#include "breccia/homogenisation/middle_plane.hpp"

#include "stage_labelling.hpp"

namespace breccia {

LabelImage<2> middle_plane(const Stage& stage, const StageMicrostructure& packed, std::size_t normal) {
  constexpr int pixels = 500;
  const auto labelling = labelling_in_space(stage, packed);
  const std::size_t across = (normal + 1) % 3, up = (normal + 2) % 3;
  LabelImage<2> plane = {.pixels = {pixels, pixels},
                         .pixel_side = stage.side / pixels,
                         .walls = packed.microstructure.walls,
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

}  // namespace breccia
