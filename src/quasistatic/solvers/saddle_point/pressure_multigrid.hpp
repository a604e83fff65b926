#pragma once

#include <cstddef>

#include "quasistatic/operator/petsc_handle.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// An approximate inverse of the Schur complement of the pressures,
///
///     S = 1/k + a/G + B_q diag(H)^-1 B_q',
///
/// with the volume changes B_q q by flows, and their resistance H: in gaps it is the equation of lubrication, elsewhere
/// the usual mass matrix over a shear modulus (Elman, Silvester and Wathen 2014, section 3.5). It is a cycle of
/// algebraic multigrid (PETSc's GAMG), so that its cost is proportional to the number of cells.
class PressureMultigrid {
 public:
  /// Takes the present moduli of the operator.
  explicit PressureMultigrid(const SaddlePointOperator& saddle);

  /// Finds pressures from volume changes, as entries of a field.
  void apply(const NodalField& right, NodalField& solution) const;

 private:
  std::size_t first_pressure_;
  PetscInt cells_;
  Matrix schur_complement_;
  LinearSolver solver_;
};

}  // namespace breccia::quasistatic
