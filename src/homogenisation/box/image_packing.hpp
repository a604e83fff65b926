#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// Fills a box with the image of a stage.
template <int dim>
PlacedBox<dim> placed(const Stage&, const ImagePacking<dim>& pixels, PackingRunner&) {
  return {pixels.image};
}

}  // namespace breccia
