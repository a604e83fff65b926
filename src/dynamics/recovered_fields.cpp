#include "dynamics/recovered_fields.hpp"

#include <array>
#include <cstddef>

#include "discretisation/cell_shape.hpp"
#include "dynamics/layer_exchange.hpp"
#include "dynamics/point_map.hpp"

namespace breccia::dynamics {
namespace {

/// Contribution of the Maxwell terms to the stress of a point: G applied to its strain, with engineering shears, and K
/// to its volumetric strain [Pa].
template <int dim>
struct HistoryAtPoint {
  std::array<double, static_cast<std::size_t>(tensor_components<dim>)> shear;
  double pressure;
};

/// The modes of the terms combine like those of the strain. Modes without a bulk history are zero.
template <int dim>
HistoryAtPoint<dim> at_point(const typename BlockLayout<dim>::Histories& history, Volumetric volumetric, int point) {
  const PointMap<dim> at(point);
  HistoryAtPoint<dim> sum{};
  if (volumetric == Volumetric::averaged) {
    at.template find_strain<true>(history.shear.data(), sum.shear.data());
  } else {
    at.template find_strain<false>(history.shear.data(), sum.shear.data());
  }
  sum.pressure = at.template volume<false>(history.bulk.data());
  return sum;
}

/// Stress of a point under a strain with engineering shears [Pa], its three normal components, also in plane strain,
/// and then the shears: the springs, then the Maxwell terms.
template <int dim>
typename decltype(PointFields<dim>::stress)::value_type stress_of(const DynamicProblem<dim>& problem, PhaseIndex phase,
                                                                  int point,
                                                                  const typename CellShape<dim>::StrainVector& strain,
                                                                  const typename BlockLayout<dim>::Histories& history) {
  const auto& [name, density, bulk, shear] = problem.materials[phase];
  const double h = problem.discretisation.grid().cell_side;
  const auto of_terms = at_point<dim>(history, problem.volumetric, point);
  const double pressure = bulk.equilibrium() * strain.template head<dim>().sum() + of_terms.pressure / h;
  std::array<double, static_cast<std::size_t>(tensor_components<dim>)> g{};
  for (std::size_t i = 0; i < g.size(); ++i) {
    g[i] = shear.equilibrium() * strain[static_cast<Eigen::Index>(i)] + of_terms.shear[i] / h;
  }
  typename decltype(PointFields<dim>::stress)::value_type stress{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double others = 0.0;
    for (std::size_t other = 0; other < dim; ++other) others += other != axis ? g[other] : 0.0;
    stress[axis] = pressure + 4.0 / 3.0 * (axis < dim ? g[axis] : 0.0) - 2.0 / 3.0 * others;
  }
  for (std::size_t shear_index = dim; shear_index < g.size(); ++shear_index) {
    stress[shear_index + 3 - dim] = g[shear_index];
  }
  return stress;
}

template <int dim>
void set_fields_of_cell(const DynamicProblem<dim>& problem, const NodalField<dim>& nodes,
                        const BlockLayout<dim>& layout, const Index<dim>& cell, LatticeFields<dim>& fields) {
  using Shape = CellShape<dim>;
  const auto& discretisation = problem.discretisation;
  const auto& grid = discretisation.grid();
  const typename Shape::Values u = nodes.displacement_of_cell(cell);
  for (int p = 0; p < Shape::points; ++p) {
    const auto phase = discretisation.cell(cell)[static_cast<std::size_t>(p)];
    if (phase == no_phase) continue;
    const auto index = place_in_timed_fields(fields.cells, cell, p);
    const auto weights = Shape::weights(p);
    Vector<dim> displacement{};
    for (std::size_t node = 0; node < weights.size(); ++node) {
      for (std::size_t i = 0; i < dim; ++i) {
        displacement[i] += weights[node] * u[static_cast<Eigen::Index>(dim * node + i)];
      }
    }
    put_in_timed_fields<dim>(displacement, fields.displacement[index]);
    const typename Shape::StrainVector strain = Shape::strain_matrix(p, problem.volumetric) * u / grid.cell_side;
    std::array<double, Shape::strains> components{};
    for (int i = 0; i < Shape::strains; ++i) {
      components[static_cast<std::size_t>(i)] = i < dim ? strain[i] : 0.5 * strain[i];
    }
    put_in_timed_fields<dim>(components, fields.strain[index]);
    put_in_timed_fields<dim>(stress_of<dim>(problem, phase, p, strain, layout.histories(cell, phase)),
                             fields.stress[index]);
  }
}

}  // namespace

template <int dim>
LatticeFields<dim> recover_fields(const DynamicProblem<dim>& problem, const NodalField<dim>& nodes,
                                  const BlockLayout<dim>& layout) {
  const auto cells = own_layers(problem.discretisation.grid());
  auto fields = zero_timed_fields(problem.discretisation, cells);
  for_each_index(cells.begin, cells.end,
                 [&](const Index<dim>& cell) { set_fields_of_cell(problem, nodes, layout, cell, fields); });
  return fields;
}

template LatticeFields<2> recover_fields(const DynamicProblem<2>&, const NodalField<2>&, const BlockLayout<2>&);
template LatticeFields<3> recover_fields(const DynamicProblem<3>&, const NodalField<3>&, const BlockLayout<3>&);

}  // namespace breccia::dynamics
