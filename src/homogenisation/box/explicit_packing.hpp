#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// Fills a box with the particles of a list. Throws InputError where particles, with their coatings, overlap or cross a
/// wall. Instantiated for 2 and 3 dimensions.
template <int dim>
PlacedBox<dim> placed(const Stage& stage, const ExplicitPacking<dim>& listed, PackingRunner& runner);

}  // namespace breccia
