#pragma once

#include "breccia/study/stage.hpp"

#include "homogenisation/box/packing_runner.hpp"
#include "homogenisation/box/placed_box.hpp"

namespace breccia {

/// Fills a box with the grains of listed sites, or of random sites for the sizes of the filler. Throws InputError where
/// the films take up all grains. Instantiated for 2 and 3 dimensions.
template <int dim>
PlacedBox<dim> placed(const Stage& stage, const LaguerrePacking<dim>& method, PackingRunner& runner);

}  // namespace breccia
