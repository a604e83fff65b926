// The state of a run: memory, momentum, energy, fields and checkpoints. The steps are in layer_step.cpp.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/cell_shape.hpp"
#include "breccia/parallel/ordered_values.hpp"
#include "breccia/parallel/reduction.hpp"

#include "boundary_nodes.hpp"
#include "nodal_mass.hpp"
#include "total_lagrangian.hpp"

namespace breccia::dynamics {
namespace {

/// Values at the nodes of a cell, from those along the rows of nodes around it.
template <int dim, class Components>
typename CellShape<dim>::Values cell_values(const NodalField<dim>& nodes, const Index<dim>& cell,
                                            Components (NodalField<dim>::*components)(int) const) {
  typename CellShape<dim>::Values values;
  for (int n = 0; n < CellShape<dim>::nodes; ++n) {
    auto node = CellShape<dim>::corner(n);
    for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] += cell[axis];
    const auto of_row = (nodes.*components)(nodes.row_of(node));
    for (int i = 0; i < dim; ++i) values[dim * n + i] = of_row[static_cast<std::size_t>(i)][node[0]];
  }
  return values;
}

template <int dim>
typename CellShape<dim>::Values cell_displacements(const NodalField<dim>& nodes, const Index<dim>& cell) {
  return cell_values<dim>(nodes, cell, &NodalField<dim>::displacement);
}

template <int dim>
typename CellShape<dim>::Values cell_increments(const NodalField<dim>& nodes, const Index<dim>& cell) {
  return cell_values<dim>(nodes, cell, &NodalField<dim>::increment);
}

template <int dim>
typename CellShape<dim>::PointModuli elastic_moduli(const DynamicProblem<dim>& problem, const Index<dim>& cell) {
  typename CellShape<dim>::PointModuli moduli{};
  const auto& phases = problem.discretisation.cell(cell);
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    if (phases[p] == no_phase) continue;
    const auto& material = problem.materials[phases[p]];
    moduli[p] = {material.bulk.equilibrium(), material.shear.equilibrium()};
  }
  return moduli;
}

/// What the Maxwell terms add to the stress of a point: G applied to its strain, with engineering shears, and K to its
/// volumetric strain [Pa].
template <int dim>
struct HistoryAtPoint {
  std::array<double, static_cast<std::size_t>(tensor_components<dim>)> shear;
  double pressure;
};

/// The modes of the terms combine as those of the strain do (theory, Eq. 6).
HistoryAtPoint<2> at_point(const BlockLayout<2>::Histories& history, Volumetric volumetric, int point) {
  const auto [x, y] = CellShape<2>::offset(point);
  const auto& [sxx, syy, sxy, squ, sqv] = history.shear;
  const auto& [centre, bqu, bqv] = history.bulk;
  const bool averaged = volumetric == Volumetric::averaged;
  const double along_x = averaged ? 0.5 * (y * squ - x * sqv) : y * squ;
  const double along_y = averaged ? -along_x : x * sqv;
  return {{sxx + along_x, syy + along_y, sxy + x * squ + y * sqv}, centre + y * bqu + x * bqv};
}

/// The same with the modes of a cube (theory, Eq. 73). Those without a bulk history are zero there.
HistoryAtPoint<3> at_point(const BlockLayout<3>::Histories& history, Volumetric /*volumetric*/, int point) {
  constexpr std::size_t axes = 3;
  const auto offset = CellShape<3>::offset(point);
  const auto twist = [&](std::size_t c, std::size_t d) { return history.shear[6 + axes * c + d]; };
  const auto sign = [&](std::size_t axis) { return 4.0 * offset[axis]; };
  const auto gradient = [&](std::size_t c, std::size_t d) {
    const auto e = (d + 1) % axes, f = (d + 2) % axes;
    return sign(e) * twist(c, f) + sign(f) * twist(c, e) + sign(e) * sign(f) * history.shear[15 + c];
  };
  HistoryAtPoint<3> sum = {{}, history.bulk[0]};
  for (std::size_t c = 0; c < axes; ++c) {
    const auto d = (c + 1) % axes, e = (c + 2) % axes;
    sum.shear[c] = history.shear[c] + gradient(c, c);
    sum.shear[axes + c] = history.shear[axes + c] + gradient(d, e) + gradient(e, d);
    sum.pressure += sign(c) * history.bulk[1 + c] + sign(d) * sign(e) * history.bulk[1 + axes + c];
  }
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
  const auto of_terms = at_point(history, problem.volumetric, point);
  const double pressure = bulk.equilibrium() * strain.template head<dim>().sum() + of_terms.pressure / h;
  std::array<double, static_cast<std::size_t>(tensor_components<dim>)> g;
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

}  // namespace

template <int dim>
Footprint TotalLagrangian<dim>::footprint() const {
  constexpr std::size_t fields_moved = 4 * dim + 1;  // one more than twice dim read, of which all others are written
  const auto layers = static_cast<std::size_t>(exchange_.end() - exchange_.first());
  const auto& nodes = layers_.nodes();
  const auto& layout = layers_.layout();
  return {.held = problem().discretisation.cells().size() * sizeof(CellPhases<dim>) + layout.material_bytes() +
                  layout.history_bytes() + nodes.bytes() + schedule_.bytes(),
          .moved_per_step = layers * nodes.layer_size() * fields_moved * sizeof(double) + layout.material_bytes() +
                            2 * layout.history_bytes()};
}

template <int dim>
template <class Action>
void TotalLagrangian<dim>::for_own_nodes(Action&& action) const {
  for (int layer = exchange_.first(); layer < exchange_.end_of_nodes(); ++layer) {
    for_nodes_of_layer(problem().discretisation.grid(), layer, action);
  }
}

template <int dim>
Vector<dim> TotalLagrangian<dim>::momentum() const {
  Vector<dim> momentum{};
  const auto& nodes = layers_.nodes();
  parallel::sum_in_order(momentum, [&](std::span<double> sums) {
    for_own_nodes([&](const Index<dim>& node) {
      if (is_image(problem(), node)) return;
      const auto increment = nodes.increment(nodes.row_of(node));
      const double mass = nodal_mass(problem(), node);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += mass * increment[i][node[0]] / problem().time_step;
    });
  });
  return momentum;
}

template <int dim>
Energy TotalLagrangian<dim>::energy() const {
  require_elastic();
  const auto& grid = problem().discretisation.grid();
  const auto& nodes = layers_.nodes();
  const auto cells = own_layers(grid);
  std::array<double, 2> kinetic_and_strain{};
  parallel::sum_in_order(kinetic_and_strain, [&](std::span<double> sums) {
    for_own_nodes([&](const Index<dim>& node) {
      if (is_image(problem(), node)) return;
      double squared = 0.0;
      for (const double* increment : nodes.increment(nodes.row_of(node))) {
        const double velocity = increment[node[0]] / problem().time_step;
        squared += velocity * velocity;
      }
      sums[0] += 0.5 * nodal_mass(problem(), node) * squared;
    });
    for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) {
      const typename CellShape<dim>::Values u = cell_displacements(nodes, cell);
      const typename CellShape<dim>::Values du = cell_increments(nodes, cell);
      const auto stiffness = CellShape<dim>::stiffness(elastic_moduli(problem(), cell), problem().volumetric);
      sums[1] += times_power<dim - 2>(0.5 * u.dot(stiffness * (u - du)), grid.cell_side);
    });
  });
  return {.kinetic = kinetic_and_strain[0], .strain = kinetic_and_strain[1]};
}

template <int dim>
void TotalLagrangian<dim>::set_fields_of_cell(LatticeFields<dim>& fields, const Index<dim>& cell) const {
  using Shape = CellShape<dim>;
  const auto& discretisation = problem().discretisation;
  const auto& grid = discretisation.grid();
  const auto& nodes = layers_.nodes();
  const typename Shape::Values u = cell_displacements(nodes, cell);
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
    const typename Shape::StrainVector strain = Shape::strain_matrix(p, problem().volumetric) * u / grid.cell_side;
    std::array<double, Shape::strains> components{};
    for (int i = 0; i < Shape::strains; ++i) {
      components[static_cast<std::size_t>(i)] = i < dim ? strain[i] : 0.5 * strain[i];
    }
    put_in_timed_fields<dim>(components, fields.strain[index]);
    put_in_timed_fields<dim>(stress_of<dim>(problem(), phase, p, strain, layers_.layout().histories(cell, phase)),
                             fields.stress[index]);
  }
}

template <int dim>
LatticeFields<dim> TotalLagrangian<dim>::fields() const {
  const auto cells = own_layers(problem().discretisation.grid());
  auto fields = zero_timed_fields(problem().discretisation, cells);
  for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) { set_fields_of_cell(fields, cell); });
  return fields;
}

template <int dim>
Vector<dim> TotalLagrangian<dim>::most_moved() const {
  const auto& nodes = layers_.nodes();
  Vector<dim> position{};
  double most = 0.0;
  for_own_nodes([&](const Index<dim>& node) {
    double moved = 0.0;
    for (const double* increment : nodes.increment(nodes.row_of(node))) moved = std::hypot(moved, increment[node[0]]);
    // A value that is not finite counts as the largest.
    if (!std::isfinite(moved)) moved = std::numeric_limits<double>::infinity();
    if (moved <= most) return;
    most = moved;
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
      position[axis] = node[axis] * problem().discretisation.grid().cell_side;
    }
  });
  const bool is_here = parallel::is_first_largest(most);
  for (double& along : position) along = parallel::sum(is_here ? along : 0.0);
  return position;
}

/// Number of the values of all layers of nodes of the box.
template <int dim>
std::size_t TotalLagrangian<dim>::values_of_all_nodes() const {
  const auto layers = static_cast<std::size_t>(problem().discretisation.grid().cells.back() + 1);
  return layers * layers_.nodes().values_of_layer();
}

template <int dim>
void TotalLagrangian<dim>::save_arrays(StateWriter& state, const std::string& group) const {
  const auto& nodes = layers_.nodes();
  const auto first = static_cast<std::size_t>(exchange_.first()) * nodes.values_of_layer();
  const auto own = nodes.values(exchange_.first(), exchange_.end_of_nodes());
  state.write(group + "/nodes", own, parallel::consecutive_places(first, own.size()), values_of_all_nodes());
  const auto history = layers_.layout().history();
  const auto [indices, count] = exchange_.share_of(history.size());
  state.write(group + "/history", history, indices, count);
}

template <int dim>
void TotalLagrangian<dim>::restore_arrays(const StateReader& state, const std::string& group) {
  // A layer of nodes that several processes hold is read by each of them.
  auto& nodes = layers_.nodes();
  state.read(group + "/nodes", nodes.values(), nodes.indices(), values_of_all_nodes());
  const auto history = layers_.layout().history();
  const auto [indices, count] = exchange_.share_of(history.size());
  state.read(group + "/history", history, indices, count);
}

template std::size_t TotalLagrangian<2>::values_of_all_nodes() const;
template Footprint TotalLagrangian<2>::footprint() const;
template void TotalLagrangian<2>::set_fields_of_cell(LatticeFields<2>&, const Index<2>&) const;
template Vector<2> TotalLagrangian<2>::momentum() const;
template Energy TotalLagrangian<2>::energy() const;
template LatticeFields<2> TotalLagrangian<2>::fields() const;
template Vector<2> TotalLagrangian<2>::most_moved() const;
template void TotalLagrangian<2>::save_arrays(StateWriter&, const std::string&) const;
template void TotalLagrangian<2>::restore_arrays(const StateReader&, const std::string&);
template std::size_t TotalLagrangian<3>::values_of_all_nodes() const;
template Footprint TotalLagrangian<3>::footprint() const;
template void TotalLagrangian<3>::set_fields_of_cell(LatticeFields<3>&, const Index<3>&) const;
template Vector<3> TotalLagrangian<3>::momentum() const;
template Energy TotalLagrangian<3>::energy() const;
template LatticeFields<3> TotalLagrangian<3>::fields() const;
template Vector<3> TotalLagrangian<3>::most_moved() const;
template void TotalLagrangian<3>::save_arrays(StateWriter&, const std::string&) const;
template void TotalLagrangian<3>::restore_arrays(const StateReader&, const std::string&);

}  // namespace breccia::dynamics
