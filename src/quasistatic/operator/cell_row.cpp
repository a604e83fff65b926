#include "quasistatic/operator/cell_row.hpp"

namespace breccia::quasistatic {
namespace {

/// Sums and differences of one component of the displacement over the corners of a cell. `x` is the difference along
/// the first axis summed over the other axes; `xy` is the difference along the first two, and so on.
struct Differences {
  double x, y, z, xy, yz, zx, xyz;
};

/// The differences that follow from the sums over the four rows, which are `stride` apart, at the two nodes of a cell
/// along the row.
inline Differences differences(const double* sums, std::size_t stride) noexcept {
  const double *all = sums, *y = sums + stride, *z = sums + 2 * stride, *yz = sums + 3 * stride;
  return {.x = all[1] - all[0],
          .y = y[1] + y[0],
          .z = z[1] + z[0],
          .xy = y[1] - y[0],
          .yz = yz[1] + yz[0],
          .zx = z[1] - z[0],
          .xyz = yz[1] - yz[0]};
}

/// Stores the forces conjugate to the differences as forces on the sums over the four rows: first on the difference
/// between the two nodes, then on the upper and the lower node for each of the three other sums.
inline void store(const Differences& force, double* forces, std::size_t stride) noexcept {
  forces[0] = force.x;
  forces[stride] = force.y + force.xy;
  forces[2 * stride] = force.y - force.xy;
  forces[3 * stride] = force.z + force.zx;
  forces[4 * stride] = force.z - force.zx;
  forces[5 * stride] = force.yz + force.xyz;
  forces[6 * stride] = force.yz - force.xyz;
}

}  // namespace

CellRow::CellRow(int cells)
    : cells_(static_cast<std::size_t>(cells)),
      stride_(cells_ + 2),
      sums_(sums_of_node * stride_),
      forces_(forces_of_cell * stride_) {}

void CellRow::add_forces(const EdgeRows<const double>& displacement, const double* shear, const double* bulk,
                         const EdgeRows<double>& forces) {
  add_up_rows(displacement);
  find_forces(shear, bulk);
  distribute(forces);
}

/// Combines the four rows: their sum, the differences along the second and along the third axis, and the difference
/// along both.
void CellRow::add_up_rows(const EdgeRows<const double>& displacement) {
  for (std::size_t component = 0; component < 3; ++component) {
    const auto& rows = displacement[component];
    const double *row_0 = rows[0], *row_1 = rows[1], *row_2 = rows[2], *row_3 = rows[3];
    double* all = sums_.data() + 4 * component * stride_;
    double *y = all + stride_, *z = all + 2 * stride_, *yz = all + 3 * stride_;
#pragma omp simd
    for (std::size_t node = 0; node <= cells_; ++node) {
      const double lower = row_0[node] + row_1[node], upper = row_2[node] + row_3[node];
      const double below = row_1[node] - row_0[node], above = row_3[node] - row_2[node];
      all[node] = lower + upper;
      y[node] = below + above;
      z[node] = upper - lower;
      yz[node] = above - below;
    }
  }
}

/// Finds the forces by Eq. 71 of the theory. The scales of the strains, 1/4, 1/8 and 1/16 of a difference, enter
/// squared.
void CellRow::find_forces(const double* shear, const double* bulk) {
  constexpr double two_thirds = 2.0 / 3.0;
  const double* sums = sums_.data();
  double* forces = forces_.data() + 1;
  const std::size_t stride = stride_, cells = cells_;
#pragma omp simd
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto u = differences(sums + cell, stride);
    const auto v = differences(sums + 4 * stride + cell, stride);
    const auto w = differences(sums + 8 * stride + cell, stride);
    const double mean = shear[cell] / 16.0, linear = shear[cell] / 64.0, bilinear = shear[cell] * (10.0 / 768.0);
    const double pressure = (bulk[cell] / 16.0 - two_thirds * mean) * (u.x + v.y + w.z);
    const double xy = mean * (u.y + v.x), yz = mean * (v.z + w.y), zx = mean * (w.x + u.z);
    // Strains that change sign along the first, second or third axis: two thirds of their traces, and a sum of shears.
    const double along_x = two_thirds * (v.xy + w.zx), along_y = two_thirds * (u.xy + w.yz),
                 along_z = two_thirds * (u.zx + v.yz);
    const double mixed = u.yz + v.zx + w.xy;
    store({.x = 2.0 * mean * u.x + pressure,
           .y = xy,
           .z = zx,
           .xy = linear * (3.0 * u.xy - along_y),
           .yz = linear * (u.yz + mixed),
           .zx = linear * (3.0 * u.zx - along_z),
           .xyz = bilinear * u.xyz},
          forces + cell, stride);
    store({.x = xy,
           .y = 2.0 * mean * v.y + pressure,
           .z = yz,
           .xy = linear * (3.0 * v.xy - along_x),
           .yz = linear * (3.0 * v.yz - along_z),
           .zx = linear * (v.zx + mixed),
           .xyz = bilinear * v.xyz},
          forces + 7 * stride + cell, stride);
    store({.x = zx,
           .y = yz,
           .z = 2.0 * mean * w.z + pressure,
           .xy = linear * (w.xy + mixed),
           .yz = linear * (3.0 * w.yz - along_y),
           .zx = linear * (3.0 * w.zx - along_x),
           .xyz = bilinear * w.xyz},
          forces + 14 * stride + cell, stride);
  }
}

/// Adds the forces of the cells on both sides of each node, and spreads them over the four rows.
void CellRow::distribute(const EdgeRows<double>& forces) const {
  for (std::size_t component = 0; component < 3; ++component) {
    const auto& rows = forces[component];
    double *row_0 = rows[0], *row_1 = rows[1], *row_2 = rows[2], *row_3 = rows[3];
    // The force at an index is that of the cell before a node; the force of the cell behind the node is at the next
    // index.
    const double* x = forces_.data() + 7 * component * stride_;
    const double *y_upper = x + stride_, *y_lower = y_upper + stride_, *z_upper = y_lower + stride_,
                 *z_lower = z_upper + stride_, *yz_upper = z_lower + stride_, *yz_lower = yz_upper + stride_;
#pragma omp simd
    for (std::size_t node = 0; node <= cells_; ++node) {
      const double all = x[node] - x[node + 1];
      const double y = y_upper[node] + y_lower[node + 1], z = z_upper[node] + z_lower[node + 1];
      const double yz = yz_upper[node] + yz_lower[node + 1];
      row_0[node] += (all - y) - (z - yz);
      row_1[node] += (all + y) - (z + yz);
      row_2[node] += (all - y) + (z - yz);
      row_3[node] += (all + y) + (z + yz);
    }
  }
}

}  // namespace breccia::quasistatic
