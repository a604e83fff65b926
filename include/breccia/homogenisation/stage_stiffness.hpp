#pragma once

#include <optional>
#include <span>
#include <vector>

#include "breccia/study/test_id.hpp"

namespace breccia {

/// The stiffness of a stage at a time after a step of the strain.
struct StiffnessSample {
  double time = 0.0;  ///< [s]
  /// C_ij with i <= j, row by row [Pa], of the stiffness that takes the strain in Voigt's order with engineering shears
  /// to the stress: 21 numbers in space (xx, yy, zz, yz, zx, xy), 6 in plane strain (xx, yy, xy).
  std::vector<double> constants = {};
  /// Largest whole error of the moduli under the single loads [-]; nothing where one of them is not known. An error
  /// delta of every modulus leaves C_ij uncertain by delta sqrt(C_ii C_jj) (theory, Eq. 13e).
  std::optional<double> error = {};
};

/// The whole stiffness of a stage under one boundary, by the quasi-static method.
struct StageStiffness {
  TestId test;  ///< the isotropic mean on the same grid
  std::vector<StiffnessSample> samples = {};
};

/// The isotropic stiffness that is nearest to a stiffness, and the distance between them.
struct IsotropicPart {
  double bulk = 0.0;   ///< [Pa]; of a plane stiffness as that of a body in plane strain
  double shear = 0.0;  ///< [Pa]
  /// The universal index of anisotropy [-], 0 for an isotropic stiffness (theory, Eq. 13f; Ranganathan and
  /// Ostoja-Starzewski, 2008); nothing for a stiffness that is not positive definite.
  std::optional<double> anisotropy = {};
};

/// The isotropic part of a stiffness with these constants, as in StiffnessSample. Throws InputError for another number
/// of them than 6 or 21.
IsotropicPart isotropic_part(std::span<const double> constants);

}  // namespace breccia
