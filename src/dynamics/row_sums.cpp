#include "row_sums.hpp"

#include "breccia/discretisation/cell_shape.hpp"

#include "step_times.hpp"

namespace breccia::dynamics {

Averages<2> averages_of(const DynamicProblem<2>& problem, const RowSums& sums, int place, std::int64_t step) {
  const auto& grid = problem.discretisation.grid();
  Stress<2> stress;
  Strain<2> strain;
  for (int row = 0; row <= grid.rows(); ++row) {
    const auto& of_row = sums.of(row, place);
    for (int i = 0; i < tensor_components<2>; ++i) {
      component(stress, i) += of_row.stress[static_cast<std::size_t>(i)];
      component(strain, i) += component(of_row.strain, i);
    }
  }
  const double per_point = 1.0 / (static_cast<double>(grid.cell_count() * CellShape<2>::points) * grid.cell_side);
  if (problem.boundary != Boundary::traction)
    return {scaled(per_point, stress), scaled(load_at(problem, step), problem.load)};
  return {scaled(per_point, stress), scaled(1.0 / grid.volume(), strain)};
}

}  // namespace breccia::dynamics
