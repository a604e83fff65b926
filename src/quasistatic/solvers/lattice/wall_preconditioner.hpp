#pragma once

#include <array>
#include <vector>

#include "quasistatic/solvers/lattice/lattice_preconditioner.hpp"
#include "quasistatic/solvers/lattice/row_exchange.hpp"
#include "quasistatic/solvers/lattice/wall_transform.hpp"
#include "quasistatic/solvers/lattice/wave_symbol.hpp"

namespace breccia::quasistatic {

/// The inverse of the shear modulus times the Laplacian of each component, for a box with walls: by sine transforms
/// where the displacements of the nodes on the walls are zero, by cosine transforms where the walls are free. Equal
/// displacements of all nodes of a free box, which have no forces, are left at zero.
class WallPreconditioner final : public LatticePreconditioner {
 public:
  WallPreconditioner(const NodeLattice& lattice, int threads);

  void apply(const Moduli& reference, const NodalField& forces, NodalField& displacement) override;

 private:
  /// Rows of nodes of a plane or, across the planes, of those with one index along the second axis; `first` is the
  /// first node.
  [[nodiscard]] PairedRows rows_along(std::size_t axis, double* first) const;
  void transform(std::size_t axis, double* first, std::complex<double>* waves) const;
  void double_ends(std::size_t axis, double* values) const;
  void transform_planes(const NodalField& forces, NodalField& waves) const;
  void divide_by_laplacian(const Moduli& reference, NodalField& waves);
  void transform_planes_back(NodalField& waves) const;
  void divide_row(const Moduli& reference, std::size_t second, double* values) const;

  NodeLattice lattice_;
  RowExchange exchange_;
  int threads_;
  bool is_fixed_;                                 ///< whether the displacements of the nodes on the walls are zero
  std::array<std::vector<HalfAngle>, 3> angles_;  ///< half angles by axis
  std::vector<WallTransform> transforms_;         ///< transforms by axis; each is its own inverse, apart from a factor
  std::array<std::vector<Waves>, 3> waves_;       ///< memory of the transforms, by axis and thread
};

}  // namespace breccia::quasistatic
