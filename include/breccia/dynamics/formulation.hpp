#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// How the equations of the dynamic method are arranged. Both have the same solution.
enum class Formulation {
  total_lagrangian,  ///< fixed connectivity, velocities on the nodes: the fast one
  classical          ///< moving points, momenta extrapolated every step: the paper's, the reference
};

template <>
inline constexpr auto words<Formulation> = std::to_array<Word<Formulation>>(
    {{"total-lagrangian", Formulation::total_lagrangian}, {"classical", Formulation::classical}});

/// The nodes that move while a displacement boundary is ramped. A periodic box always starts affine: it has no boundary
/// that could move first. Under a traction boundary nothing is made to move.
enum class Start {
  boundary,  ///< the boundary alone; waves carry the strain inwards (the paper's)
  affine     ///< the whole field
};

template <>
inline constexpr auto words<Start> = std::to_array<Word<Start>>({{"boundary", Start::boundary},
                                                                 {"affine", Start::affine}});

}  // namespace breccia
