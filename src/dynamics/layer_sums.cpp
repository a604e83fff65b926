#include "dynamics/layer_sums.hpp"

#include "discretisation/cell_shape.hpp"
#include "dynamics/step_times.hpp"

namespace breccia::dynamics {

template <int dim>
Averages<dim> averages_of(const DynamicProblem<dim>& problem, const LayerSums<dim>& sums, int index,
                          std::int64_t step) {
  const auto& grid = problem.discretisation.grid();
  Stress<dim> stress;
  Strain<dim> strain;
  for (int layer = 0; layer <= grid.cells.back(); ++layer) {
    const auto& of_layer = sums.of(layer, index);
    for (int i = 0; i < tensor_components<dim>; ++i) {
      component(stress, i) += of_layer.stress[static_cast<std::size_t>(i)];
      component(strain, i) += component(of_layer.strain, i);
    }
  }
  const double per_point = 1.0 / (static_cast<double>(grid.cell_count() * CellShape<dim>::points) * grid.cell_side);
  if (problem.boundary != Boundary::traction)
    return {scaled(per_point, stress), scaled(load_at(problem, step), problem.load)};
  return {scaled(per_point, stress), scaled(1.0 / grid.volume(), strain)};
}

template Averages<2> averages_of(const DynamicProblem<2>&, const LayerSums<2>&, int, std::int64_t);
template Averages<3> averages_of(const DynamicProblem<3>&, const LayerSums<3>&, int, std::int64_t);

}  // namespace breccia::dynamics
