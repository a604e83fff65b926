#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// The image of a stage, which fills its box.
template <int dim>
PlacedBox<dim> placed(const Stage&, const ImagePacking<dim>& pixels, PackingRunner&) {
  return {pixels.image};
}

}  // namespace breccia
