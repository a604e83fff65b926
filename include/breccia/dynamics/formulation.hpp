#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// The formulation of the equations of the dynamic method. Both formulations have the same solution.
enum class Formulation {
  total_lagrangian,  ///< fixed connectivity, velocities on the nodes: the faster formulation
  classical          ///< moving points, momenta extrapolated in every step: the paper's formulation, for reference
};

template <>
inline constexpr auto words<Formulation> = std::to_array<Word<Formulation>>(
    {{"total-lagrangian", Formulation::total_lagrangian}, {"classical", Formulation::classical}});

/// The nodes that move while a displacement boundary is ramped. A periodic box always starts affine: it has no boundary
/// that could move first. Under a traction boundary no node has a prescribed motion.
enum class Start {
  boundary,  ///< the nodes on the boundary alone; waves carry the strain inwards (as in the paper)
  affine     ///< all nodes
};

template <>
inline constexpr auto words<Start> = std::to_array<Word<Start>>({{"boundary", Start::boundary},
                                                                 {"affine", Start::affine}});

}  // namespace breccia
