#include "homogenisation/box/simplest_box.hpp"

#include <utility>

namespace breccia {

Box<2> simplest_box(ParticleBox box) {
  if (auto discs = as_discs(box)) return *std::move(discs);
  return box;
}

Box<3> simplest_box(EllipsoidBox box) {
  if (auto spheres = as_balls(box)) return *std::move(spheres);
  return box;
}

}  // namespace breccia
