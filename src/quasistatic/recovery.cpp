#include "recovery.hpp"

#include <cstddef>

#include "breccia/parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

/// A displacement on the nodes of the whole box, in units of the cell side.
class NodalDisplacement {
 public:
  NodalDisplacement(const ElasticBox& box, const Grid<2>& grid, Load load, const Field& field)
      : grid_(grid),
        strain_(unit_strain<2>(load)),
        affine_(field.affine()),
        wraps_(box.boundary() == Boundary::periodic),
        rest_(box.gathered(field)) {}

  [[nodiscard]] CellVector of_cell(int column, int row) const {
    CellVector u;
    for (int node = 0; node < 4; ++node) {
      const int x = column + node % 2, y = row + node / 2;
      const auto first = 2 * place(x, y);
      u[2 * node] = affine_ * (strain_.xx * x + strain_.xy * y) + rest_[first];
      u[2 * node + 1] = affine_ * (strain_.xy * x + strain_.yy * y) + rest_[first + 1];
    }
    return u;
  }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const noexcept {
    if (!wraps_) return grid_.node_index({x, y});
    return grid_.cell_index({x % grid_.columns(), y % grid_.rows()});
  }

  Grid<2> grid_;
  Strain<2> strain_;
  double affine_;
  bool wraps_;
  std::vector<double> rest_;  ///< x and y of the nodes in turn, row by row
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

PointFields<2> recover_fields(const ElasticBox& box, const Discretisation<2>& discretisation, Volumetric volumetric,
                              Load load, const Field& displacement, const std::vector<AppliedModuli>& applied) {
  const auto& grid = discretisation.grid();
  const NodalDisplacement moved(box, grid, load, displacement);
  std::vector<AppliedToNodes> by_material;
  by_material.reserve(applied.size());
  for (const auto& [bulk, shear] : applied) {
    by_material.push_back({NodalDisplacement(box, grid, load, bulk), NodalDisplacement(box, grid, load, shear)});
  }
  auto fields = zero_fields(discretisation);
  if (parallel::rank() != 0) return fields;
  for (int p = 0; p < CellShape<2>::points; ++p) {
    const auto weights = CellShape<2>::weights(p);
    const auto strain = CellShape<2>::strain_matrix(p, volumetric);
    const auto volume = CellShape<2>::volumetric_strain_matrix(p, volumetric);
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const auto point = grid.point_index({column, row}, p);
        const CellVector u = moved.of_cell(column, row);
        for (std::size_t node = 0; node < 4; ++node) {
          fields.displacement[point][0] += grid.cell_side * weights[node] * u[static_cast<Eigen::Index>(2 * node)];
          fields.displacement[point][1] += grid.cell_side * weights[node] * u[static_cast<Eigen::Index>(2 * node + 1)];
        }
        const Eigen::Vector3d e = strain * u;
        fields.strain[point] = {e[0], e[1], 0.5 * e[2]};
        const auto& [bulk, shear] = by_material[fields.phase[point]];
        fields.stress[point] = stress_of(strain * shear.of_cell(column, row), volume.dot(bulk.of_cell(column, row)));
      }
    }
  }
  return fields;
}

}  // namespace breccia::quasistatic
