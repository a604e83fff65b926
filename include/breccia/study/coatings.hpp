#pragma once

#include <cstddef>
#include <optional>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The filler of a stage that a particle belongs to.
const Filler& filler_of(const Stage& stage, const Microstructure<2>& microstructure, std::size_t particle);

/// The particles of a stage with the outer diameters of their coatings [m], which must not overlap.
Microstructure<2> with_coatings(const Stage& stage, Microstructure<2> microstructure);

/// The narrowest coating of a stage [m]; nothing where there is none.
std::optional<double> thinnest_coating(const Stage& stage);

}  // namespace breccia
