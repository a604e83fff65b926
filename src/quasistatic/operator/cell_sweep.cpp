#include "quasistatic/operator/cell_sweep.hpp"

#include <algorithm>
#include <vector>

#include <omp.h>

#include "parallel/first_exception.hpp"

namespace breccia::quasistatic {

void CellSweep::add_forces(const CellModuli& moduli, const Input& displacement, const Output& forces,
                           int threads) const {
  std::vector<Row> rows(static_cast<std::size_t>(threads), Row(cells_[0]));
  for_slabs(threads, [&](int thread, int first_plane, int end_plane) {
    add_slab(moduli, first_plane, end_plane, displacement, forces, rows[static_cast<std::size_t>(thread)]);
  });
}

void CellSweep::for_slabs(int threads, const std::function<void(int, int, int)>& work) const {
  const int slabs = (cells_[2] + planes_of_slab - 1) / planes_of_slab;
  // Neighbouring slabs share a plane of nodes, and so do the last and the first of a periodic box: every other slab is
  // taken first, then the slabs between these, then the last one if it is a neighbour of the first.
  const bool wraps = nodes_.nodes[2] == cells_[2];
  const int paired = wraps && slabs % 2 == 1 ? slabs - 1 : slabs;
  const auto take = [&](int thread, int slab) {
    const int first = slab * planes_of_slab;
    work(thread, first, std::min(first + planes_of_slab, cells_[2]));
  };
  parallel::FirstException failure;
  for (const int parity : {0, 1}) {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (int slab = parity; slab < paired; slab += 2) failure.run([&] { take(omp_get_thread_num(), slab); });
  }
  failure.rethrow();
  if (paired < slabs) take(0, paired);
}

void CellSweep::add_slab(const CellModuli& moduli, int first_plane, int end_plane, const Input& displacement,
                         const Output& forces, Row& row) const {
  for (int third = first_plane; third < end_plane; ++third) {
    for (int second = 0; second < cells_[1]; ++second) {
      EdgeRows<const double> moved{};
      EdgeRows<double> exerted{};
      for (std::size_t edge = 0; edge < 4; ++edge) {
        const auto index = nodes_.row_at(second + static_cast<int>(edge & 1U), third + static_cast<int>(edge >> 1U));
        for (std::size_t component = 0; component < 3; ++component) {
          moved[component][edge] = displacement[component] + index;
          exerted[component][edge] = forces[component] + index;
        }
      }
      const auto* kinds = moduli.kind_of.row_at(second, third);
      for (std::size_t cell = 0; cell < row.shear.size(); ++cell) {
        row.shear[cell] = moduli.shear[kinds[cell]];
        row.bulk[cell] = moduli.bulk[kinds[cell]];
      }
      row.forces.add_forces(moved, row.shear.data(), row.bulk.data(), exerted);
    }
  }
  add_others(moduli, first_plane, end_plane, displacement, forces);
}

void CellSweep::add_others(const CellModuli& moduli, int first_plane, int end_plane, const Input& displacement,
                           const Output& forces) const {
  using Shape = CellShape<3>;
  const auto plane_of = [](const CellModuli::OfManyMaterials& other) { return other.cell[2]; };
  auto other = std::ranges::lower_bound(moduli.others, first_plane, {}, plane_of);
  for (; other != moduli.others.end() && other->cell[2] < end_plane; ++other) {
    typename Shape::Values values;
    for (int node = 0; node < Shape::nodes; ++node) {
      const auto index = index_of(other->cell, node);
      for (int component = 0; component < 3; ++component) {
        values[3 * node + component] = displacement[static_cast<std::size_t>(component)][index];
      }
    }
    const typename Shape::Values exerted = moduli.stiffnesses[other->stiffness] * values;
    for (int node = 0; node < Shape::nodes; ++node) {
      const auto index = index_of(other->cell, node);
      for (int component = 0; component < 3; ++component) {
        forces[static_cast<std::size_t>(component)][index] += exerted[3 * node + component];
      }
    }
  }
}

/// Index of a node of a cell in the arrays.
std::size_t CellSweep::index_of(const Index<3>& cell, int node) const noexcept {
  const auto corner = CellShape<3>::corner(node);
  return nodes_.row_at(cell[1] + corner[1], cell[2] + corner[2]) + static_cast<std::size_t>(cell[0] + corner[0]);
}

}  // namespace breccia::quasistatic
