#pragma once

#include <cstddef>
#include <optional>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The filler of a stage that a particle belongs to.
template <int dim>
const Filler& filler_of(const Stage& stage, const Microstructure<dim>& microstructure, std::size_t particle) {
  return stage.fillers.at(microstructure.filler_of(particle));
}

/// The particles of a stage with the outer diameters of their coatings [m], which must not overlap. Instantiated for 2
/// and 3 dimensions.
template <int dim>
Microstructure<dim> with_coatings(const Stage& stage, Microstructure<dim> microstructure);

/// The narrowest coating of a stage [m]; nothing where there is none.
std::optional<double> thinnest_coating(const Stage& stage);

}  // namespace breccia
