#pragma once

#include <array>
#include <string>

#include "breccia/words.hpp"

namespace breccia {

/// The boundary condition of a virtual test. The first two give apparent moduli of the box that bound the effective
/// ones from above and from below, in the mean over many boxes (Huet 1990).
enum class Boundary {
  displacement,  ///< kinematic uniform (KUBC): nodes on the boundary follow the affine motion of the load
  traction,      ///< static uniform (SUBC): the uniform traction of the load's stress acts on the boundary
  periodic       ///< displacements on opposite sides differ by the affine motion of the load
};

template <>
inline constexpr auto words<Boundary> = std::to_array<Word<Boundary>>({{"displacement", Boundary::displacement},
                                                                       {"traction", Boundary::traction},
                                                                       {"periodic", Boundary::periodic}});

/// The relation of the apparent modulus under a boundary condition to the effective one: "upper bound", "lower bound"
/// or "periodic".
std::string bound_of(Boundary boundary);

}  // namespace breccia
