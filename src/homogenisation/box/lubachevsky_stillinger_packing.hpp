#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// Fills a box with discs or spheres that grow until they have their sizes. Throws NumericalError where they jam.
/// Instantiated for 2 and 3 dimensions.
template <int dim>
PlacedBox<dim> placed(const Stage& stage, const LubachevskyStillingerPacking<dim>& method, PackingRunner& runner);

}  // namespace breccia
