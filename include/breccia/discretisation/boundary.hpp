#pragma once

#include <array>

#include "breccia/words.hpp"

namespace breccia {

/// The boundary condition of a virtual test. The first two give apparent moduli of the box. Where the box is a window
/// in a larger body, they bound the effective modulus from above and from below, in the mean over many windows (Huet
/// 1990); a box with walls, which cut no particle, is no window.
enum class Boundary {
  displacement,  ///< kinematic uniform (KUBC): nodes on the boundary follow the affine motion of the load
  traction,      ///< static uniform (SUBC): the uniform traction of the load's stress acts on the boundary
  periodic       ///< displacements on opposite sides differ by the affine motion of the load
};

template <>
inline constexpr auto words<Boundary> = std::to_array<Word<Boundary>>({{"displacement", Boundary::displacement},
                                                                       {"traction", Boundary::traction},
                                                                       {"periodic", Boundary::periodic}});

}  // namespace breccia
