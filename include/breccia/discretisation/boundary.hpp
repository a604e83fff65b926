#pragma once

namespace breccia {

/// The boundary condition of a virtual test.
enum class Boundary {
  displacement,  ///< kinematic uniform (KUBC): nodes on the boundary follow the affine motion of the load; the apparent
                 ///< modulus bounds the effective one from above
  traction,      ///< static uniform (SUBC): the load's stress pulls on the boundary; bounds it from below
  periodic       ///< displacements on opposite sides differ by the affine motion of the load; no bound
};

}  // namespace breccia
