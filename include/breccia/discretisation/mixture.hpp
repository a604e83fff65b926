#pragma once

#include <array>
#include <vector>

#include "breccia/discretisation/phase.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The treatment of a cell that an interface crosses.
enum class Mixing {
  series,  ///< a mixture of its phases by area fraction (theory, Eq. 40; fillers softer than the matrix: Eq. 40a)
  flow,    ///< as series, with a flow of the matrix through gaps narrower than a cell (theory, Eqs. 42c to 42h)
  points   ///< each of its material points has the phase at its position, as in the paper
};

/// Whether cells that an interface crosses are mixtures of their phases.
constexpr bool has_mixed_cells(Mixing mixing) {
  return mixing != Mixing::points;
}

template <>
inline constexpr auto words<Mixing> =
    std::to_array<Word<Mixing>>({{"series", Mixing::series}, {"flow", Mixing::flow}, {"points", Mixing::points}});

/// A phase in a mixed cell, with its share of the cell.
struct MixedPart {
  PhaseIndex phase;
  double fraction;  ///< share of the area or volume of the cell [-]

  friend bool operator==(const MixedPart&, const MixedPart&) = default;
};

/// The content of a mixed cell: at least two phases, whose fractions add up to 1.
using Mixture = std::vector<MixedPart>;

}  // namespace breccia
