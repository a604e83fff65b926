#include "operator/recovery.hpp"

#include <cstddef>

#include "breccia/parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

/// The displacement of all nodes of the box, in units of the cell side.
class NodalDisplacement {
 public:
  NodalDisplacement(const ElasticOperator& elastic_operator, const Grid& grid, Load load,
                    const Displacement& displacement)
      : grid_(grid),
        strain_(unit_strain(load)),
        macroscopic_(displacement.macroscopic()),
        wraps_(elastic_operator.boundary() == Boundary::periodic),
        fluctuation_(elastic_operator.gathered(displacement)) {}

  [[nodiscard]] CellVector of_cell(int column, int row) const {
    CellVector u;
    for (int node = 0; node < 4; ++node) {
      const int x = column + node % 2, y = row + node / 2;
      const auto first = 2 * place(x, y);
      u[2 * node] = macroscopic_ * (strain_.xx * x + strain_.xy * y) + fluctuation_[first];
      u[2 * node + 1] = macroscopic_ * (strain_.xy * x + strain_.yy * y) + fluctuation_[first + 1];
    }
    return u;
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const noexcept {
    if (!wraps_) return grid_.node_index(x, y);
    return grid_.cell_index(x % grid_.columns, y % grid_.rows);
  }

  Grid grid_;
  PlaneStrain strain_;
  double macroscopic_;
  bool wraps_;
  std::vector<double> fluctuation_;  ///< x and y of the nodes in turn, row by row
};

struct AppliedToNodes {
  NodalDisplacement bulk, shear;
};

std::array<double, 4> stress_of(const Eigen::Vector3d& shear, double pressure) {
  const auto& [xx, yy, xy] = std::array{shear[0], shear[1], shear[2]};
  return {pressure + 4.0 / 3.0 * xx - 2.0 / 3.0 * yy, pressure + 4.0 / 3.0 * yy - 2.0 / 3.0 * xx,
          pressure - 2.0 / 3.0 * (xx + yy), xy};
}

}  // namespace

PointFields recover_fields(const ElasticOperator& elastic_operator, const Discretisation& discretisation,
                           Volumetric volumetric, Load load, const Displacement& displacement,
                           const std::vector<AppliedModuli>& applied) {
  const auto& grid = discretisation.grid();
  const NodalDisplacement moved(elastic_operator, grid, load, displacement);
  std::vector<AppliedToNodes> by_material;
  by_material.reserve(applied.size());
  for (const auto& [bulk, shear] : applied) {
    by_material.push_back({NodalDisplacement(elastic_operator, grid, load, bulk),
                           NodalDisplacement(elastic_operator, grid, load, shear)});
  }
  auto fields = zero_fields(discretisation);
  if (parallel::rank() != 0) return fields;
  for (int p = 0; p < points_per_cell; ++p) {
    const auto weights = node_weights(p);
    const auto strain = strain_matrix(p, volumetric);
    const auto volume = volumetric_strain_matrix(p, volumetric);
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const auto point = grid.point_index(column, row, p);
        const CellVector u = moved.of_cell(column, row);
        for (std::size_t node = 0; node < 4; ++node) {
          fields.displacement[point][0] += grid.cell_side * weights[node] * u[static_cast<Eigen::Index>(2 * node)];
          fields.displacement[point][1] += grid.cell_side * weights[node] * u[static_cast<Eigen::Index>(2 * node + 1)];
        }
        const Eigen::Vector3d e = strain * u;
        fields.strain[point] = {e[0], e[1], 0.5 * e[2]};
        const auto& [bulk, shear] = by_material[fields.material[point]];
        fields.stress[point] = stress_of(strain * shear.of_cell(column, row), volume.dot(bulk.of_cell(column, row)));
      }
    }
  }
  return fields;
}

}  // namespace breccia::quasistatic
