#pragma once

#include <array>
#include <complex>
#include <memory>
#include <vector>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"
#include "quasistatic/solvers/lattice/lattice_preconditioner.hpp"
#include "quasistatic/solvers/lattice/row_exchange.hpp"
#include "quasistatic/solvers/lattice/wave_symbol.hpp"

namespace breccia::quasistatic {

/// The inverse of the operator of a periodic box of one material, by Fourier transforms. Equal displacements of all
/// nodes, which have no forces, are left at zero.
class PeriodicPreconditioner final : public LatticePreconditioner {
 public:
  PeriodicPreconditioner(const NodeLattice& lattice, int threads);

  void apply(const Moduli& reference, const NodalField& forces, NodalField& displacement) override;

 private:
  using Complex = std::complex<double>;

  void transform_planes(const NodalField& forces, NodalField& waves) const;
  void divide_by_symbol(const Moduli& reference, NodalField& waves);
  void transform_planes_back(NodalField& waves) const;
  void divide_row(const Moduli& reference, int second, Complex* waves) const;

  NodeLattice lattice_;
  RowExchange exchange_;
  int threads_;
  std::size_t waves_;  ///< number of waves along the first axis: the transform of real values has about half of them
  std::array<std::vector<HalfAngle>, 3> angles_;  ///< half angles by axis
  std::unique_ptr<RealTransform> along_first_;
  std::unique_ptr<WaveTransform> along_second_, back_along_second_, along_third_, back_along_third_;
  std::vector<Waves> rows_of_waves_;  ///< the three components of the waves of a row along the second axis, by thread
};

}  // namespace breccia::quasistatic
