#pragma once

#include <memory>

#include "breccia/discretisation/moduli.hpp"

#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// The inverse of the elastic operator of a box of one material, or of a similar operator: the preconditioner of
/// conjugate gradients on a lattice.
class LatticePreconditioner {
 public:
  LatticePreconditioner() = default;
  LatticePreconditioner(const LatticePreconditioner&) = delete;
  LatticePreconditioner& operator=(const LatticePreconditioner&) = delete;
  LatticePreconditioner(LatticePreconditioner&&) = delete;
  LatticePreconditioner& operator=(LatticePreconditioner&&) = delete;
  virtual ~LatticePreconditioner() = default;

  /// Finds the displacements of a box whose material has these moduli [Pa], under these forces.
  virtual void apply(const Moduli& reference, const NodalField& forces, NodalField& displacement) = 0;
};

/// The preconditioner for the boundary condition of a lattice: by Fourier transforms with the exact operator of the
/// material for a periodic boundary; by sine or cosine transforms with the shear modulus times the Laplacian of each
/// component for the other boundaries.
[[nodiscard]] std::unique_ptr<LatticePreconditioner> make_lattice_preconditioner(const NodeLattice& lattice,
                                                                                 int threads);

}  // namespace breccia::quasistatic
