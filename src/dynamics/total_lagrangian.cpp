#include "total_lagrangian.hpp"

#include <algorithm>
#include <utility>

#include <omp.h>

#include "breccia/mpm/cell.hpp"

#include "barrier.hpp"
#include "instruction_set.hpp"
#include "nodal_masses.hpp"

namespace breccia::dynamics {
namespace {

/// Length of a row of nodes: all blocks and the node to their right, in whole blocks, and never close to a multiple of
/// 512 bytes, where rows would compete for the same cache sets.
std::size_t padded_length(int blocks_per_row) {
  const auto length = static_cast<std::size_t>(blocks_per_row + 1) * lanes;
  return length % 64 == 0 ? length + lanes : length;
}

}  // namespace

TotalLagrangian::ForceRow::ForceRow(std::size_t length) {
  for (auto& component : values) component.assign(length, 0.0);
}

RowForces TotalLagrangian::ForceRow::view() noexcept {
  return {values[0].data(), values[1].data(), values[2].data(), values[3].data()};
}

TotalLagrangian::TotalLagrangian(DynamicProblem problem, int threads)
    : DynamicSolver(std::move(problem)),
      kernels_(&kernels(chosen_instruction_set())),
      layout_(this->problem()),
      stride_(padded_length(layout_.blocks_per_row())),
      masses_(nodal_masses(this->problem())),
      nothing_(stride_) {
  const auto& grid = this->problem().discretisation.grid();
  nodes_.assign(stride_ * 5 * static_cast<std::size_t>(grid.rows + 1), 0.0);
  const double squared_step = this->problem().time_step * this->problem().time_step;
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      step_over_mass(row)[column] = is_prescribed(column, row) || *mass == 0.0 ? 0.0 : squared_step / *mass;
    }
  }
  row_stresses_.assign(static_cast<std::size_t>(grid.rows) * 6, 0.0);
  // With less to do than this a thread would mostly wait for the others.
  constexpr std::size_t points_per_thread = 8192;
  const auto useful = static_cast<int>(this->problem().discretisation.points() / points_per_thread);
  const int bands = std::clamp(std::min(threads, useful), 1, grid.rows);
  for (int band = 0; band < bands; ++band) {
    bands_.push_back({grid.rows * band / bands, grid.rows * (band + 1) / bands, ForceRow(stride_), ForceRow(stride_),
                      ForceRow(stride_), ForceRow(stride_)});
  }
}

bool TotalLagrangian::is_prescribed(int column, int row) const noexcept {
  const auto& grid = problem().discretisation.grid();
  return problem().boundary == Boundary::displacement &&
         (column == 0 || row == 0 || column == grid.columns || row == grid.rows);
}

void TotalLagrangian::set_velocities(const VelocityField& velocity) {
  const auto& grid = problem().discretisation.grid();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      if (is_prescribed(column, row)) continue;
      const auto v = velocity({column * grid.cell_side, row * grid.cell_side});
      increment(row).x[column] = problem().time_step * v[0];
      increment(row).y[column] = problem().time_step * v[1];
    }
  }
}

void TotalLagrangian::take_steps(std::int64_t first, int steps, PlaneStress* stresses) {
  Barrier barrier;
#pragma omp parallel num_threads(bands_.size())
  {
    // OpenMP may grant fewer threads than there are bands.
    const int threads = omp_get_num_threads();
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    for (int i = 0; i < steps; ++i) {
      for (auto band = thread; band < bands_.size(); band += static_cast<std::size_t>(threads)) {
        sweep(bands_[band], first + i);
      }
      barrier.wait(threads);
      for (auto band = thread; band < bands_.size(); band += static_cast<std::size_t>(threads)) {
        join_bands(band, first + i);
      }
      if (thread == 0) stresses[i] = average_stress(first + i);
      barrier.wait(threads);
    }
  }
}

void TotalLagrangian::sweep(Band& band, std::int64_t step) {
  for (int row = band.first; row < band.end; ++row) {
    const auto below = displacement(row), above = displacement(row + 1);
    const auto step_below = increment(row), step_above = increment(row + 1);
    auto& bottom = row == band.first ? band.lowest : band.bottom;
    const CellRow cells = {.blocks = layout_.row(row),
                           .block_count = layout_.blocks_per_row(),
                           .displacement_below = {below.x, below.y},
                           .displacement_above = {above.x, above.y},
                           .increment_below = {step_below.x, step_below.y},
                           .increment_above = {step_above.x, step_above.y},
                           .below = bottom.view(),
                           .above = band.top.view(),
                           .stress = stress_of_row(row, step)};
    if (problem().volumetric == Volumetric::averaged) {
      kernels_->cell_row_averaged(cells);
    } else {
      kernels_->cell_row_standard(cells);
    }
    if (row > band.first) move_row(row, band.highest.view(), bottom.view(), step);
    std::swap(band.top, band.highest);
  }
}

void TotalLagrangian::join_bands(std::size_t band, std::int64_t step) {
  auto& own = bands_[band];
  move_row(own.first, band > 0 ? bands_[band - 1].highest.view() : nothing_.view(), own.lowest.view(), step);
  if (band + 1 == bands_.size()) move_row(own.end, own.highest.view(), nothing_.view(), step);
}

void TotalLagrangian::move_row(int row, const RowForces& from_cells_below, const RowForces& from_cells_above,
                               std::int64_t step) {
  const auto u = displacement(row), du = increment(row);
  kernels_->node_row({.count = (layout_.blocks_per_row() + 1) * lanes,
                      .displacement_x = u.x,
                      .displacement_y = u.y,
                      .increment_x = du.x,
                      .increment_y = du.y,
                      .step_over_mass = step_over_mass(row),
                      .from_cells_below = from_cells_below,
                      .from_cells_above = from_cells_above});
  if (problem().boundary == Boundary::displacement && load_at(step - 1) < 1.0) follow_load(row, step);
}

void TotalLagrangian::follow_load(int row, std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const auto& load = problem().load;
  const double now = load_at(step);
  const double next = load_at(step + 1);
  const double acceleration = next - 2.0 * now + load_at(step - 1);
  const auto u = displacement(row), du = increment(row);
  for (int column = 0; column <= grid.columns; ++column) {
    const double x = column * grid.cell_side, y = row * grid.cell_side;
    const Vector<2> affine = {load.xx * x + load.xy * y, load.xy * x + load.yy * y};
    if (is_prescribed(column, row)) {
      u.x[column] = next * affine[0];
      u.y[column] = next * affine[1];
      du.x[column] = (next - now) * affine[0];
      du.y[column] = (next - now) * affine[1];
    } else if (problem().start == Start::affine) {
      u.x[column] += acceleration * affine[0];
      u.y[column] += acceleration * affine[1];
      du.x[column] += acceleration * affine[0];
      du.y[column] += acceleration * affine[1];
    }
  }
}

double* TotalLagrangian::stress_of_row(int row, std::int64_t step) {
  const auto half = row_stresses_.size() / 2;
  return row_stresses_.data() + (step % 2 == 0 ? 0 : half) + 3 * static_cast<std::size_t>(row);
}

PlaneStress TotalLagrangian::average_stress(std::int64_t step) const {
  const auto& grid = problem().discretisation.grid();
  const auto half = row_stresses_.size() / 2;
  const double* row = row_stresses_.data() + (step % 2 == 0 ? 0 : half);
  PlaneStress sum;
  for (int j = 0; j < grid.rows; ++j, row += 3) {
    sum.xx += row[0];
    sum.yy += row[1];
    sum.xy += row[2];
  }
  const double scale = 1.0 / (static_cast<double>(grid.cells() * points_per_cell) * grid.cell_side);
  return {scale * sum.xx, scale * sum.yy, scale * sum.xy};
}

Vector<2> TotalLagrangian::momentum() const {
  const auto& grid = problem().discretisation.grid();
  Vector<2> sum = {0.0, 0.0};
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      sum[0] += *mass * field(row, 2)[column] / problem().time_step;
      sum[1] += *mass * field(row, 3)[column] / problem().time_step;
    }
  }
  return sum;
}

CellVector TotalLagrangian::cell_values(int column, int row, int first_field) const {
  const double* x0 = field(row, first_field) + column;
  const double* y0 = field(row, first_field + 1) + column;
  const double* x1 = field(row + 1, first_field) + column;
  const double* y1 = field(row + 1, first_field + 1) + column;
  CellVector values;
  values << x0[0], y0[0], x0[1], y0[1], x1[0], y1[0], x1[1], y1[1];
  return values;
}

Energy TotalLagrangian::energy() const {
  require_elastic();
  const auto& grid = problem().discretisation.grid();
  Energy energy;
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      const double vx = field(row, 2)[column] / problem().time_step, vy = field(row, 3)[column] / problem().time_step;
      energy.kinetic += 0.5 * *mass * (vx * vx + vy * vy);
    }
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      std::array<Moduli, points_per_cell> moduli{};
      for (std::size_t p = 0; p < points_per_cell; ++p) {
        const auto index = problem().discretisation.cell(column, row)[p];
        if (index == no_material) continue;
        const auto& material = problem().materials[index];
        moduli[p] = {material.bulk.equilibrium(), material.shear.equilibrium()};
      }
      const CellVector u = cell_values(column, row, 0), du = cell_values(column, row, 2);
      energy.strain += 0.5 * u.dot(cell_stiffness(moduli, problem().volumetric) * (u - du));
    }
  }
  return energy;
}

PointFields TotalLagrangian::fields() const {
  const auto& discretisation = problem().discretisation;
  const auto& grid = discretisation.grid();
  PointFields fields;
  fields.material.resize(discretisation.points());
  fields.displacement.resize(discretisation.points());
  fields.strain.resize(discretisation.points());
  fields.stress.resize(discretisation.points());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const CellVector u = cell_values(column, row, 0);
      for (int p = 0; p < points_per_cell; ++p) {
        const auto material = discretisation.cell(column, row)[static_cast<std::size_t>(p)];
        const auto point = grid.point_index(column, row, p);
        fields.material[point] = material;
        if (material == no_material) continue;
        const auto weights = node_weights(p);
        for (std::size_t node = 0; node < 4; ++node) {
          fields.displacement[point][0] += weights[node] * u[static_cast<Eigen::Index>(2 * node)];
          fields.displacement[point][1] += weights[node] * u[static_cast<Eigen::Index>(2 * node + 1)];
        }
        const Eigen::Vector3d strain = strain_matrix(p, problem().volumetric) * u / grid.cell_side;
        fields.strain[point] = {strain[0], strain[1], 0.5 * strain[2]};

        // Modulus times strain: the springs, then the Maxwell terms, whose modes combine as those of the strain do.
        const auto& [name, density, bulk, shear] = problem().materials[material];
        const auto history = layout_.histories(column, row, material);
        const auto& [x, y] = point_offsets[static_cast<std::size_t>(p)];
        const auto& [sxx, syy, sxy, squ, sqv] = history.shear;
        const auto& [centre, bqu, bqv] = history.bulk;
        const bool averaged = problem().volumetric == Volumetric::averaged;
        const double along_x = averaged ? 0.5 * (y * squ - x * sqv) : y * squ;
        const double along_y = averaged ? -along_x : x * sqv;
        const double volumetric = strain[0] + strain[1];
        const double pressure = bulk.equilibrium() * volumetric + (centre + y * bqu + x * bqv) / grid.cell_side;
        const double gxx = shear.equilibrium() * strain[0] + (sxx + along_x) / grid.cell_side;
        const double gyy = shear.equilibrium() * strain[1] + (syy + along_y) / grid.cell_side;
        const double gxy = shear.equilibrium() * strain[2] + (sxy + x * squ + y * sqv) / grid.cell_side;
        fields.stress[point] = {pressure + 4.0 / 3.0 * gxx - 2.0 / 3.0 * gyy,
                                pressure + 4.0 / 3.0 * gyy - 2.0 / 3.0 * gxx, pressure - 2.0 / 3.0 * (gxx + gyy), gxy};
      }
    }
  }
  return fields;
}

}  // namespace breccia::dynamics
