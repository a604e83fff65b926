#include "total_lagrangian.hpp"

#include <algorithm>
#include <utility>

#include <omp.h>

#include "breccia/discretisation/cell.hpp"

#include "boundary_nodes.hpp"
#include "kernels.hpp"
#include "nodal_masses.hpp"

namespace breccia::dynamics {
namespace {

/// Length of a row of nodes: all blocks and the node to their right, in whole blocks, and never close to a multiple of
/// 512 bytes, where rows would compete for the same cache sets.
std::size_t padded_length(const Grid& grid) {
  const int blocks_per_row = (grid.columns + lanes - 1) / lanes;
  const auto length = static_cast<std::size_t>(blocks_per_row + 1) * lanes;
  return length % 64 == 0 ? length + lanes : length;
}

/// Steps whose sums of rows are kept: few enough to leave the caches to the nodes.
int steps_of_chunk(const Grid& grid) {
  constexpr int most_sums = 1 << 10;
  return std::max(1, most_sums / (grid.rows + 1));
}

/// Gives the nodes at both ends of a row the forces of the cells at the other end.
void join_ends(const RowForces& forces, int columns) {
  forces.right_x[0] = forces.right_x[columns];
  forces.right_y[0] = forces.right_y[columns];
  forces.left_x[columns] = forces.left_x[0];
  forces.left_y[columns] = forces.left_y[0];
}

}  // namespace

TotalLagrangian::ForceRow::ForceRow(std::size_t length) {
  for (auto& component : values) component.assign(length, 0.0);
}

RowForces TotalLagrangian::ForceRow::view() noexcept {
  return {values[0].data(), values[1].data(), values[2].data(), values[3].data()};
}

TotalLagrangian::TotalLagrangian(DynamicProblem problem, int threads, InstructionSet instructions)
    : DynamicSolver(std::move(problem)),
      kernels_(&kernels(instructions)),
      stride_(padded_length(this->problem().discretisation.grid())),
      exchange_(this->problem().discretisation.grid(), this->problem().boundary == Boundary::periodic, stride_),
      layout_(this->problem(), exchange_.first(), exchange_.end()),
      masses_(nodal_masses(this->problem())),
      from_below_(stride_),
      from_above_(stride_),
      chunk_(steps_of_chunk(this->problem().discretisation.grid())) {
  const auto& grid = this->problem().discretisation.grid();
  // What comes from the left and the right cells is one sum by then.
  for (auto* forces : {&from_below_, &from_above_}) {
    std::ranges::fill(forces->values[2], -0.0);
    std::ranges::fill(forces->values[3], -0.0);
  }
  nodes_.assign(stride_ * 5 * static_cast<std::size_t>(grid.rows + 1), 0.0);
  const double squared_step = this->problem().time_step * this->problem().time_step;
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      step_over_mass(row)[column] =
          is_prescribed(this->problem(), column, row) || *mass == 0.0 ? 0.0 : squared_step / *mass;
    }
  }
  // With less to do than this a thread would mostly wait for the others.
  constexpr std::size_t points_per_thread = 8192;
  const auto useful = static_cast<int>(this->problem().discretisation.points() / points_per_thread);
  const int first = exchange_.first(), rows = exchange_.end() - first;
  const int bands = std::clamp(std::min(threads, useful), 1, rows);
  crew_ = Crew(std::min(bands, omp_get_num_procs()));
  for (int band = 0; band < bands; ++band) {
    bands_.push_back({first + rows * band / bands, first + rows * (band + 1) / bands, ForceRow(stride_),
                      ForceRow(stride_), ForceRow(stride_), ForceRow(stride_), ForceRow(stride_)});
  }
  progress_ = std::vector<Progress>(bands_.size());
  row_sums_.resize((static_cast<std::size_t>(grid.rows) + 1) * static_cast<std::size_t>(chunk_));
}

void TotalLagrangian::set_velocities(const VelocityField& velocity) {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      if (is_prescribed(problem(), column, row)) continue;
      const int x = wraps && column == grid.columns ? 0 : column, y = wraps && row == grid.rows ? 0 : row;
      const auto v = velocity({x * grid.cell_side, y * grid.cell_side});
      increment(row).x[column] = problem().time_step * v[0];
      increment(row).y[column] = problem().time_step * v[1];
    }
  }
}

void TotalLagrangian::take_steps(std::int64_t first, int steps, Averages* averages) {
  for (int done = 0; done < steps;) {
    const int taken = take_turn(first + done, steps - done, averages + done);
    crew_.judge(taken);
    done += taken;
  }
}

/// Takes as many steps as have time in a turn, in whole chunks, after which the number of threads may be another.
/// Returns their number.
int TotalLagrangian::take_turn(std::int64_t first, int most_steps, Averages* averages) {
  constexpr double longest = 0.015;  // [s]
  for (auto& progress : progress_) {
    progress.swept.reset();
    progress.moved.reset();
  }
  outer_forces_.reset();
  summed_.reset();
  // Changed by the first thread alone, while the others wait for the sums of a chunk.
  int steps = most_steps;
#pragma omp parallel num_threads(crew_.threads())
  {
    const ThreadWatch watch;
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    // Neighbouring bands go to a thread that has several.
    const auto begin = bands_.size() * thread / threads, end = bands_.size() * (thread + 1) / threads;
    for (int taken = 0; taken < steps;) {
      const int chunk = std::min(chunk_, most_steps - taken);
      for (int i = 0; i < chunk; ++i, ++taken) take_step(begin, end, first + taken, taken);
      if (thread == 0) {
        sum_rows(first + taken - chunk, taken, chunk, averages + taken - chunk);
        if (watch.wall() > longest) steps = taken;
        summed_.reach(taken);
      }
      summed_.wait_for(taken);
    }
    crew_.add(thread, watch.time());
  }
  return steps;
}

/// The part of a step in some bands; `done` steps of the turn are done.
void TotalLagrangian::take_step(std::size_t first_band, std::size_t end_band, std::int64_t step, int done) {
  for (auto band = first_band; band < end_band; ++band) sweep(band, step, done);
  if (first_band == 0 && exchange_.has_neighbours()) take_outer_forces(done);
  for (auto band = first_band; band < end_band; ++band) move_lowest_row(band, step, done);
}

void TotalLagrangian::sweep(std::size_t place, std::int64_t step, int done) {
  const auto& grid = problem().discretisation.grid();
  auto& band = bands_[place];
  for (int row = band.first; row < band.end; ++row) {
    const bool last = row + 1 == band.end;
    // The band above moves the nodes there, and from the forces of this band.
    if (last) progress_[(place + 1) % bands_.size()].moved.wait_for(done);
    const auto below = displacement(row), above = displacement(row + 1);
    const auto step_below = increment(row), step_above = increment(row + 1);
    auto& bottom = row == band.first ? band.lowest : band.bottom;
    auto& top = last ? band.highest : band.top;
    auto& sums = sums_of(row, done);
    const CellRow cells = {.blocks = layout_.row(row),
                           .block_count = layout_.blocks_per_row(),
                           .displacement_below = {below.x, below.y},
                           .displacement_above = {above.x, above.y},
                           .increment_below = {step_below.x, step_below.y},
                           .increment_above = {step_above.x, step_above.y},
                           .below = bottom.view(),
                           .above = top.view(),
                           .stress = sums.stress.data()};
    if (problem().volumetric == Volumetric::averaged) {
      kernels_->cell_row_averaged(cells);
    } else {
      kernels_->cell_row_standard(cells);
    }
    switch (problem().boundary) {
      case Boundary::displacement:
        break;
      case Boundary::traction:
        sums.strain = boundary_strain(row);
        if (row + 1 == grid.rows) sums_of(grid.rows, done).strain = boundary_strain(grid.rows);
        break;
      case Boundary::periodic:
        join_ends(cells.below, grid.columns);
        join_ends(cells.above, grid.columns);
        break;
    }
    if (row == exchange_.first() && exchange_.has_neighbours()) exchange_.begin(bottom.view());
    if (row > band.first) move_row(row, band.carried.view(), bottom.view(), step);
    std::swap(band.top, band.carried);
  }
  progress_[place].swept.reach(done + 1);
}

/// Takes what the neighbouring processes, or the ends of a periodic box, add to the outer rows of nodes.
void TotalLagrangian::take_outer_forces(int done) {
  progress_.back().swept.wait_for(done + 1);
  exchange_.finish(bands_.back().highest.view(), from_below_.view(), from_above_.view());
  outer_forces_.reach(done + 1);
}

void TotalLagrangian::move_lowest_row(std::size_t place, std::int64_t step, int done) {
  const int rows = problem().discretisation.grid().rows;
  const bool wraps = problem().boundary == Boundary::periodic;
  auto& own = bands_[place];
  if (place > 0) progress_[place - 1].swept.wait_for(done + 1);
  move_row(own.first, (place > 0 ? bands_[place - 1].highest : from_below_).view(), own.lowest.view(), step);
  if (wraps && own.first == 0 && exchange_.end() == rows) copy_lowest_row(step);
  if (place + 1 == bands_.size()) {
    if (exchange_.has_neighbours()) outer_forces_.wait_for(done + 1);
    if (!wraps || own.end < rows) {
      move_row(own.end, own.highest.view(), from_above_.view(), step);
    } else if (exchange_.first() > 0) {
      move_row(0, own.highest.view(), from_above_.view(), step);
      copy_lowest_row(step);
    }
  }
  progress_[place].moved.reach(done + 1);
}

/// Averages of the steps of a chunk, once all threads have come so far.
void TotalLagrangian::sum_rows(std::int64_t first, int taken, int steps, Averages* averages) {
  for (const auto& progress : progress_) progress.moved.wait_for(taken);
  static_assert(sizeof(RowSums) == 6 * sizeof(double));
  exchange_.gather_node_rows({row_sums_.front().stress.data(), 6 * row_sums_.size()});
  for (int i = 0; i < steps; ++i) averages[i] = this->averages(first + i, i);
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
  switch (problem().boundary) {
    case Boundary::displacement:
      if (load_at(step - 1) < 1.0) follow_load(row, step);
      break;
    case Boundary::traction:
      add_traction(row, step);
      break;
    case Boundary::periodic:
      if (load_at(step - 1) < 1.0) follow_load(row, step);
      close_row(row, step);
      break;
  }
}

void TotalLagrangian::follow_load(int row, std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const double now = load_at(step);
  const double next = load_at(step + 1);
  const auto u = displacement(row), du = increment(row);
  if (follows_affinely(problem())) {
    const double acceleration = next - 2.0 * now + load_at(step - 1);
    for (int column = 0; column <= grid.columns; ++column) {
      const auto affine = affine_motion(problem(), column, row);
      u.x[column] += acceleration * affine[0];
      u.y[column] += acceleration * affine[1];
      du.x[column] += acceleration * affine[0];
      du.y[column] += acceleration * affine[1];
    }
  }
  if (problem().boundary != Boundary::displacement) return;
  for_boundary_nodes(grid, row, [&](int column) {
    const auto affine = affine_motion(problem(), column, row);
    u.x[column] = next * affine[0];
    u.y[column] = next * affine[1];
    du.x[column] = (next - now) * affine[0];
    du.y[column] = (next - now) * affine[1];
  });
}

void TotalLagrangian::add_traction(int row, std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const double now = load_at(step);
  const auto u = displacement(row), du = increment(row);
  for_boundary_nodes(grid, row, [&](int column) {
    const auto force = traction_force(problem(), column, row);
    const double scale = now * step_over_mass(row)[column];
    u.x[column] += scale * force[0];
    u.y[column] += scale * force[1];
    du.x[column] += scale * force[0];
    du.y[column] += scale * force[1];
  });
}

/// Makes the last node of a row the image of the first.
void TotalLagrangian::close_row(int row, std::int64_t step) {
  const int last = problem().discretisation.grid().columns;
  const auto across = affine_difference(problem(), last, 0);
  const double next = load_at(step + 1), rise = next - load_at(step);
  const auto u = displacement(row), du = increment(row);
  u.x[last] = u.x[0] + next * across[0];
  u.y[last] = u.y[0] + next * across[1];
  du.x[last] = du.x[0] + rise * across[0];
  du.y[last] = du.y[0] + rise * across[1];
}

/// Makes the highest row of nodes the image of the lowest.
void TotalLagrangian::copy_lowest_row(std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const auto up = affine_difference(problem(), 0, grid.rows);
  const double next = load_at(step + 1), rise = next - load_at(step);
  const auto from_u = displacement(0), from_du = increment(0);
  const auto u = displacement(grid.rows), du = increment(grid.rows);
  for (int column = 0; column <= grid.columns; ++column) {
    u.x[column] = from_u.x[column] + next * up[0];
    u.y[column] = from_u.y[column] + next * up[1];
    du.x[column] = from_du.x[column] + rise * up[0];
    du.y[column] = from_du.y[column] + rise * up[1];
  }
}

/// Share of a row of nodes in the integral of sym(u n) over the boundary [m^2].
PlaneStrain TotalLagrangian::boundary_strain(int row) const {
  const auto& grid = problem().discretisation.grid();
  PlaneStrain sum;
  for_boundary_nodes(grid, row, [&](int column) {
    const auto side = outward_side(grid, column, row);
    const double u = field(row, 0)[column], v = field(row, 1)[column];
    sum.xx += u * side[0];
    sum.yy += v * side[1];
    sum.xy += 0.5 * (u * side[1] + v * side[0]);
  });
  return sum;
}

/// Averages at a step, whose sums stand at a place among those of a chunk.
Averages TotalLagrangian::averages(std::int64_t step, int place) const {
  const auto& grid = problem().discretisation.grid();
  PlaneStress stress;
  PlaneStrain strain;
  auto of_row = static_cast<std::size_t>(place);
  for (int row = 0; row <= grid.rows; ++row, of_row += static_cast<std::size_t>(chunk_)) {
    const auto& sums = row_sums_[of_row];
    stress.xx += sums.stress[0];
    stress.yy += sums.stress[1];
    stress.xy += sums.stress[2];
    strain.xx += sums.strain.xx;
    strain.yy += sums.strain.yy;
    strain.xy += sums.strain.xy;
  }
  const double per_point = 1.0 / (static_cast<double>(grid.cells() * points_per_cell) * grid.cell_side);
  const double per_area = 1.0 / grid.area();
  Averages averages = {{per_point * stress.xx, per_point * stress.yy, per_point * stress.xy},
                       {per_area * strain.xx, per_area * strain.yy, per_area * strain.xy}};
  if (problem().boundary != Boundary::traction) {
    const auto& load = problem().load;
    const double now = load_at(step);
    averages.strain = {now * load.xx, now * load.yy, now * load.xy};
  }
  return averages;
}

}  // namespace breccia::dynamics
