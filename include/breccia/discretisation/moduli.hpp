#pragma once

namespace breccia {

/// Elastic moduli of a point or a phase.
struct Moduli {
  double bulk;   ///< [Pa]
  double shear;  ///< [Pa]
};

}  // namespace breccia
