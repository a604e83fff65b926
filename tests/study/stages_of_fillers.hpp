#pragma once

#include <utility>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia::test {

/// A filler of these sizes and this fraction.
inline Filler filler_of(Sizes sizes, double fraction) {
  Filler filler;
  filler.sizes = std::move(sizes);
  filler.fraction = fraction;
  return filler;
}

/// A periodic stage in which these fillers are packed at random.
template <int dim>
Stage stage_with(std::vector<Filler> fillers) {
  Stage stage;
  stage.packing = PackingMethod<dim>(LubachevskyStillingerPacking<dim>{Walls::periodic});
  stage.fillers = std::move(fillers);
  return stage;
}

}  // namespace breccia::test
