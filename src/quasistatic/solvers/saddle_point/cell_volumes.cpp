#include "quasistatic/solvers/saddle_point/cell_volumes.hpp"

#include <algorithm>

namespace breccia::quasistatic {
namespace {

/// The weight of the upper node of an edge along the row, which its lower one has with the other sign.
constexpr double of_edge = weight_in_volume(1, 0);

/// The weight of a row of nodes, along an axis that is not that of the row.
constexpr double of_row(std::size_t edge, std::size_t axis) noexcept {
  return weight_in_volume(2 * edge, axis);
}

}  // namespace

const std::vector<double>& CellVolumes::strains(const EdgeRows<const double>& displacement) {
  std::ranges::fill(strains_, 0.0);
  double* strains = strains_.data();
  const std::size_t cells = strains_.size();
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const double *x = displacement[0][edge], *y = displacement[1][edge], *z = displacement[2][edge];
    const double along_y = of_row(edge, 1), along_z = of_row(edge, 2);
#pragma omp simd
    for (std::size_t cell = 0; cell < cells; ++cell) {
      strains[cell] +=
          of_edge * (x[cell + 1] - x[cell]) + along_y * (y[cell] + y[cell + 1]) + along_z * (z[cell] + z[cell + 1]);
    }
  }
  return strains_;
}

void CellVolumes::add_forces(const double* stress, const EdgeRows<double>& forces) const {
  const std::size_t cells = strains_.size();
  for (std::size_t edge = 0; edge < 4; ++edge) {
    double *x = forces[0][edge], *y = forces[1][edge], *z = forces[2][edge];
    const double along_y = of_row(edge, 1), along_z = of_row(edge, 2);
    // One side of the cells after the other, so that no entry depends on the one before.
#pragma omp simd
    for (std::size_t cell = 0; cell < cells; ++cell) {
      x[cell] -= of_edge * stress[cell];
      y[cell] += along_y * stress[cell];
      z[cell] += along_z * stress[cell];
    }
#pragma omp simd
    for (std::size_t cell = 0; cell < cells; ++cell) {
      x[cell + 1] += of_edge * stress[cell];
      y[cell + 1] += along_y * stress[cell];
      z[cell + 1] += along_z * stress[cell];
    }
  }
}

}  // namespace breccia::quasistatic
