#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// How a material point sees the volumetric strain of its cell.
enum class Volumetric {
  averaged,  ///< the mean over the cell (B-bar): does not lock
  standard   ///< the point's own, as in the paper: locks where the matrix is nearly incompressible
};

template <>
inline constexpr auto words<Volumetric> = std::to_array<Word<Volumetric>>({{"averaged", Volumetric::averaged},
                                                                           {"standard", Volumetric::standard}});

}  // namespace breccia
