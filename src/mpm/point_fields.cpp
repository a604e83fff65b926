#include "breccia/mpm/point_fields.hpp"

namespace breccia {

PointFields zero_fields(const Discretisation& discretisation) {
  const auto& grid = discretisation.grid();
  const auto points = discretisation.points();
  PointFields fields;
  fields.material.resize(points);
  fields.displacement.resize(points);
  fields.strain.resize(points);
  fields.stress.resize(points);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const auto& materials = discretisation.cell(column, row);
      for (std::size_t p = 0; p < points_per_cell; ++p) {
        fields.material[grid.point_index(column, row, static_cast<int>(p))] = materials[p];
      }
    }
  }
  return fields;
}

}  // namespace breccia
