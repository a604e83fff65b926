// What a run tells of its state: memory, momentum, energy and fields, and what it goes on from. The steps are in
// total_lagrangian.cpp.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "breccia/discretisation/cell.hpp"

#include "boundary_nodes.hpp"
#include "total_lagrangian.hpp"

namespace breccia::dynamics {

Footprint TotalLagrangian::footprint() const {
  constexpr std::size_t fields_moved = 9;  // five read, of which four are written
  const auto rows = static_cast<std::size_t>(exchange_.end() - exchange_.first());
  const auto forces = (5 * bands_.size() + 2) * 4 * stride_;
  const auto doubles = nodes_.size() + masses_.size() + forces;
  return {.held = problem().discretisation.cells().size() * sizeof(CellMaterials) + layout_.material_bytes() +
                  layout_.history_bytes() + doubles * sizeof(double) + row_sums_.size() * sizeof(RowSums),
          .moved_per_step =
              rows * stride_ * fields_moved * sizeof(double) + layout_.material_bytes() + 2 * layout_.history_bytes()};
}

void TotalLagrangian::fetch_nodes() const {
  exchange_.gather_node_rows(nodes_);
}

Vector<2> TotalLagrangian::momentum() const {
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  Vector<2> sum = {0.0, 0.0};
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      if (is_image(problem(), column, row)) continue;
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
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  Energy energy;
  auto mass = masses_.begin();
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column, ++mass) {
      if (is_image(problem(), column, row)) continue;
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
  auto fields = zero_fields(discretisation);
  for (int row = exchange_.first(); row < exchange_.end(); ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const CellVector u = cell_values(column, row, 0);
      for (int p = 0; p < points_per_cell; ++p) {
        const auto material = discretisation.cell(column, row)[static_cast<std::size_t>(p)];
        const auto point = grid.point_index(column, row, p);
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
  exchange_.gather_cell_rows({fields.displacement.front().data(), 2 * fields.displacement.size()});
  exchange_.gather_cell_rows({fields.strain.front().data(), 3 * fields.strain.size()});
  exchange_.gather_cell_rows({fields.stress.front().data(), 4 * fields.stress.size()});
  return fields;
}

Vector<2> TotalLagrangian::most_moved() const {
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  Vector<2> place = {0.0, 0.0};
  double most = 0.0;
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      const double moved = std::hypot(field(row, 2)[column], field(row, 3)[column]);
      if (moved <= most) continue;
      most = moved;
      place = {column * grid.cell_side, row * grid.cell_side};
      if (!std::isfinite(moved)) return place;
    }
  }
  return place;
}

void TotalLagrangian::save_arrays(StateWriter& state, const std::string& group) const {
  fetch_nodes();
  state.write(group + "/nodes", nodes_);
  std::vector<double> all;
  state.write(group + "/history", exchange_.collect(layout_.history(), all));
}

void TotalLagrangian::restore_arrays(const StateReader& state, const std::string& group) {
  std::ranges::copy(state.numbers(group + "/nodes", nodes_.size()), nodes_.begin());
  const auto own = layout_.history();
  const auto [begin, size] = exchange_.place_of(own.size());
  const auto all = state.numbers(group + "/history", size);
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(begin), own.size(), own.begin());
}

}  // namespace breccia::dynamics
