#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// The volumetric strain on which the stress of a material point depends.
enum class Volumetric {
  averaged,  ///< the mean over the cell (B-bar, mean dilatation): does not lock
  standard   ///< the strain of the point itself (full integration), as in the paper: locks where the matrix is nearly
             ///< incompressible
};

template <>
inline constexpr auto words<Volumetric> = std::to_array<Word<Volumetric>>({{"averaged", Volumetric::averaged},
                                                                           {"standard", Volumetric::standard}});

}  // namespace breccia
