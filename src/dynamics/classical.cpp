#include "dynamics/classical.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "discretisation/cell_shape.hpp"
#include "discretisation/shape_function.hpp"
#include "dynamics/boundary_nodes.hpp"
#include "dynamics/maxwell_step.hpp"

namespace breccia::dynamics {
namespace {

/// The number of threads that are useful: a thread with too few points would mostly wait for the others.
int useful_threads(int threads, std::size_t points) {
  constexpr std::size_t points_for_a_thread = 4096;
  return std::clamp(static_cast<int>(points / points_for_a_thread), 1, threads);
}

/// Sum of the normal components.
template <int dim, class Components>
double trace(const Components& tensor) {
  double sum = tensor[0];
  for (std::size_t axis = 1; axis < dim; ++axis) sum += tensor[axis];
  return sum;
}

/// Adds a number to all normal components.
template <int dim, class Components>
void add_to_normal(Components& tensor, double value) {
  for (std::size_t axis = 0; axis < dim; ++axis) tensor[axis] += value;
}

/// Twice the deviator of a strain with engineering shears; in plane strain its out-of-plane component is left out.
template <int dim, class Components>
Components deviator(const Components& strain) {
  auto result = strain;
  for (std::size_t axis = 0; axis < dim; ++axis) {
    result[axis] = 4.0 / 3.0 * strain[axis];
    for (std::size_t other = 0; other < dim; ++other) {
      if (other != axis) result[axis] -= 2.0 / 3.0 * strain[other];
    }
  }
  return result;
}

}  // namespace

template <int dim>
Classical<dim>::Classical(DynamicProblem<dim> given, int threads)
    : DynamicSolver<dim>(std::move(given)), threads_(useful_threads(threads, problem().discretisation.points())) {
  const double half_step = 0.5 * problem().time_step;
  for (const auto& material : problem().materials) {
    materials_.push_back({material.bulk.equilibrium(), material.shear.equilibrium(),
                          maxwell_steps(material.bulk, half_step), maxwell_steps(material.shear, half_step)});
  }
  const auto& grid = problem().discretisation.grid();
  grid.for_each_cell([&](const Index<dim>& cell) { add_points(cell); });
  nodes_.resize(grid.node_count());
  for (int node = 0; node < CellShape<dim>::nodes; ++node) {
    node_offsets_[static_cast<std::size_t>(node)] = grid.node_index(CellShape<dim>::corner(node));
  }
  mean_stress_.resize(grid.cell_count());
  sort_points(0);
}

template <int dim>
void Classical<dim>::add_points(const Index<dim>& cell) {
  const auto& discretisation = problem().discretisation;
  const auto& grid = discretisation.grid();
  const double volume = times_power<dim>(CellShape<dim>::point_volume, grid.cell_side);
  for (int p = 0; p < CellShape<dim>::points; ++p) {
    const auto phase = discretisation.cell(cell)[static_cast<std::size_t>(p)];
    if (phase == no_phase || is_void(problem().materials[phase])) continue;
    Point point{};
    point.position = discretisation.position(cell, p);
    point.mass = problem().mass_scaling * problem().materials[phase].density * volume;
    point.phase = phase;
    point.cell = static_cast<int>(grid.cell_index(cell));
    point.history = history_.size();
    point.lattice = grid.point_index(cell, p);
    const auto& [bulk, shear, bulk_terms, shear_terms] = materials_[phase];
    history_.resize(history_.size() + components * shear_terms.size() + bulk_terms.size(), 0.0);
    points_.push_back(point);
  }
  initial_volume_ = volume * static_cast<double>(points_.size());
}

template <int dim>
void Classical<dim>::set_velocities(const VelocityField& velocity) {
  for (auto& point : points_) {
    point.velocity = velocity(point.position);
    for (double& v : point.velocity) v *= problem().amplitude;
  }
}

template <int dim>
void Classical<dim>::take_steps(std::int64_t first, int steps, Averages<dim>* averages) {
  for (int i = 0; i < steps; ++i) {
    const auto step = first + i;
    locate_points(step);
    extrapolate_momenta(step - 1);
    update_strains_by_half_a_step();
    averages[i] = this->averages();
    find_forces(step);
    update_momenta(step);
    update_points();
    extrapolate_momenta(step);
    update_strains_by_half_a_step();
  }
}

template <int dim>
template <class Action>
void Classical<dim>::for_nodes(Action&& action) {
  const auto& grid = problem().discretisation.grid();
  constexpr std::size_t last_axis = dim - 1;
#pragma omp parallel for num_threads(threads_)
  for (int slice = 0; slice <= grid.cells[last_axis]; ++slice) {
    Index<dim> begin{};
    auto end = grid.nodes();
    begin[last_axis] = slice;
    end[last_axis] = slice + 1;
    for_each_index(begin, end, [&](const Index<dim>& node) { action(nodes_[grid.node_index(node)], node); });
  }
}

/// Calls visit(point, shape function of the node at the point, cells between the node's own surroundings and those
/// where the point is) for the points around a node. The two differ where the node is on a side of a periodic box and
/// the cell on the opposite side.
template <int dim>
template <class Visit>
void Classical<dim>::for_points_around(const Index<dim>& node, Visit&& visit) const {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  for (int corner = CellShape<dim>::nodes - 1; corner >= 0; --corner) {
    const auto offset = CellShape<dim>::corner(corner);
    Index<dim> cell{}, away{};
    bool exists = true;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      const int index = node[axis] - offset[axis], count = grid.cells[axis];
      cell[axis] = wraps ? (index + count) % count : index;
      away[axis] = index - cell[axis];
      exists = exists && cell[axis] >= 0 && cell[axis] < count;
    }
    if (!exists) continue;
    const auto c = grid.cell_index(cell);
    for (std::size_t p = cell_begin_[c]; p < cell_begin_[c + 1]; ++p) {
      visit(points_[p], shape_function<dim>(static_cast<std::size_t>(corner), points_[p].local), away);
    }
  }
}

/// Velocity of the affine motion of the load between a step and the next one.
template <int dim>
Vector<dim> Classical<dim>::load_velocity(const Index<dim>& node, std::int64_t step) const {
  const double rate = problem().amplitude * (load_at(step + 1) - load_at(step)) / problem().time_step;
  auto velocity = affine_motion(problem(), node);
  for (double& v : velocity) v *= rate;
  return velocity;
}

template <int dim>
void Classical<dim>::extrapolate_momenta(std::int64_t step) {
  for_nodes([&](Node& node, const Index<dim>& index) {
    node.mass = 0.0;
    node.momentum = {};
    const auto add = [&node](double mass, const Vector<dim>& velocity) {
      for (std::size_t i = 0; i < velocity.size(); ++i) node.momentum[i] += mass * velocity[i];
    };
    for_points_around(index, [&](const Point& point, const ShapeFunction<dim>& s, const Index<dim>& away) {
      const double mass = s.weight * point.mass;
      node.mass += mass;
      add(mass, point.velocity);
      if (away != Index<dim>{}) add(mass, load_velocity(away, step));
    });
    if (is_prescribed(problem(), index)) {
      node.momentum = load_velocity(index, step);
      for (double& p : node.momentum) p *= node.mass;
    }
    node.velocity = {};
    if (node.mass == 0.0) return;
    for (std::size_t i = 0; i < node.velocity.size(); ++i) node.velocity[i] = node.momentum[i] / node.mass;
  });
}

template <int dim>
std::array<std::size_t, Classical<dim>::nodes_per_cell> Classical<dim>::nodes_of(int cell) const noexcept {
  const auto& grid = problem().discretisation.grid();
  auto nodes = node_offsets_;
  const auto lowest = grid.node_index(grid.cell_at(static_cast<std::size_t>(cell)));
  for (auto& node : nodes) node += lowest;
  return nodes;
}

/// Strain of half a step at a point.
template <int dim>
typename Classical<dim>::Components Classical<dim>::strain_step(const Point& point) const {
  const double scale = 0.5 * problem().time_step / problem().discretisation.grid().cell_side;
  const auto nodes = nodes_of(point.cell);
  Components step{};
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const auto gradient = shape_function<dim>(node, point.local).gradient;
    const auto& v = nodes_[nodes[node]].velocity;
    for (std::size_t i = 0; i < v.size(); ++i) {
      step[i] += scale * gradient[i] * v[i];
      for (std::size_t j = i + 1; j < v.size(); ++j) {
        const auto shear = component_index<dim>(static_cast<int>(i), static_cast<int>(j));
        step[static_cast<std::size_t>(shear)] += scale * (gradient[j] * v[i] + gradient[i] * v[j]);
      }
    }
  }
  return step;
}

template <int dim>
void Classical<dim>::update_strains_by_half_a_step() {
  const bool averaged = problem().volumetric == Volumetric::averaged;
  const auto cells = static_cast<int>(mean_stress_.size());
#pragma omp parallel num_threads(threads_)
  {
    std::vector<Components> steps;  // strain steps of the points of a cell
#pragma omp for
    for (int cell = 0; cell < cells; ++cell) {
      const auto c = static_cast<std::size_t>(cell);
      const auto begin = cell_begin_[c], count = cell_begin_[c + 1] - begin;
      if (count == 0) continue;
      steps.resize(count);
      double sum = 0.0;
      for (std::size_t p = 0; p < count; ++p) {
        steps[p] = strain_step(points_[begin + p]);
        sum += trace<dim>(steps[p]);
      }
      const double mean = sum / static_cast<double>(count);
      for (std::size_t p = 0; p < count; ++p) {
        if (averaged) add_to_normal<dim>(steps[p], (mean - trace<dim>(steps[p])) / dim);
        update_stress(points_[begin + p], steps[p]);
      }
    }
  }
}

template <int dim>
void Classical<dim>::update_stress(Point& point, const Components& strain_step) {
  const auto& material = materials_[point.phase];
  const double volumetric_step = trace<dim>(strain_step);
  for (std::size_t i = 0; i < components; ++i) point.strain[i] += strain_step[i];
  const auto total = deviator<dim>(point.strain), step = deviator<dim>(strain_step);
  for (std::size_t i = 0; i < components; ++i) point.deviator[i] = material.shear * total[i];
  point.pressure = material.bulk * trace<dim>(point.strain);
  double* history = history_.data() + point.history;
  for (const auto& [decay, gain] : material.shear_terms) {
    for (std::size_t i = 0; i < components; ++i, ++history) {
      *history = decay * *history + gain * step[i];
      point.deviator[i] += *history;
    }
  }
  for (const auto& [decay, gain] : material.bulk_terms) {
    *history = decay * *history + gain * volumetric_step;
    point.pressure += *history++;
  }
}

template <int dim>
void Classical<dim>::update_mean_stresses() {
  for (std::size_t cell = 0; cell < mean_stress_.size(); ++cell) {
    double sum = 0.0;
    for (std::size_t p = cell_begin_[cell]; p < cell_begin_[cell + 1]; ++p) {
      sum += points_[p].pressure + trace<dim>(points_[p].deviator) / dim;
    }
    const auto count = cell_begin_[cell + 1] - cell_begin_[cell];
    mean_stress_[cell] = count > 0 ? sum / static_cast<double>(count) : 0.0;
  }
}

template <int dim>
void Classical<dim>::find_forces(std::int64_t step) {
  const double volume_over_side =
      times_power<dim - 1>(CellShape<dim>::point_volume, problem().discretisation.grid().cell_side);
  const bool averaged = problem().volumetric == Volumetric::averaged;
  if (averaged) update_mean_stresses();
  const bool is_pulled = problem().boundary == Boundary::traction;
  const double pull = problem().amplitude * load_at(step);
  for_nodes([&](Node& node, const Index<dim>& index) {
    node.force = {};
    if (is_pulled) {
      node.force = traction_force(problem(), index);
      for (double& f : node.force) f *= pull;
    }
    for_points_around(index, [&](const Point& point, const ShapeFunction<dim>& s, const Index<dim>&) {
      auto stress = point.deviator;
      // The mean normal stress of averaged points works on the mean volumetric strain of the cell.
      add_to_normal<dim>(
          stress, averaged ? mean_stress_[static_cast<std::size_t>(point.cell)] - trace<dim>(point.deviator) / dim
                           : point.pressure);
      for (int i = 0; i < dim; ++i) {
        const auto term = [&](int j) {
          return stress[static_cast<std::size_t>(component_index<dim>(i, j))] * s.gradient[static_cast<std::size_t>(j)];
        };
        double sum = term(0);
        for (int j = 1; j < dim; ++j) sum += term(j);
        node.force[static_cast<std::size_t>(i)] -= volume_over_side * sum;
      }
    });
  });
}

template <int dim>
void Classical<dim>::update_momenta(std::int64_t step) {
  const double dt = problem().time_step;
  const bool follows = follows_affinely(problem());
  for_nodes([&](Node& node, const Index<dim>& index) {
    node.acceleration = {};
    if (node.mass == 0.0) return;
    const auto before = load_velocity(index, step - 1), after = load_velocity(index, step);
    const bool prescribed = is_prescribed(problem(), index);
    for (std::size_t i = 0; i < before.size(); ++i) {
      double acceleration = node.force[i] / node.mass;
      if (prescribed) {
        acceleration = (after[i] - before[i]) / dt;
      } else if (follows) {
        acceleration += (after[i] - before[i]) / dt;
      }
      node.acceleration[i] = acceleration;
      node.velocity[i] += dt * acceleration;
    }
  });
}

template <int dim>
void Classical<dim>::update_points() {
  const double dt = problem().time_step;
#pragma omp parallel for num_threads(threads_)
  for (auto& point : points_) {  // NOLINT(modernize-loop-convert)
    const auto nodes = nodes_of(point.cell);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      const double weight = shape_function<dim>(node, point.local).weight;
      for (std::size_t i = 0; i < point.velocity.size(); ++i) {
        point.velocity[i] += dt * weight * nodes_[nodes[node]].acceleration[i];
        const double step = dt * weight * nodes_[nodes[node]].velocity[i];
        point.position[i] += step;
        point.displacement[i] += step;
      }
    }
  }
}

template <int dim>
Averages<dim> Classical<dim>::averages() const {
  const auto& grid = problem().discretisation.grid();
  Averages<dim> sum;
  for (const auto& point : points_) {
    for (int i = 0; i < tensor_components<dim>; ++i) {
      const auto c = static_cast<std::size_t>(i);
      const bool is_normal = i < dim;
      component(sum.stress, i) += is_normal ? point.pressure + point.deviator[c] : point.deviator[c];
      component(sum.strain, i) += is_normal ? point.strain[c] : 0.5 * point.strain[c];
    }
  }
  const auto points = static_cast<double>(grid.cell_count() * CellShape<dim>::points);
  const double scale = 1.0 / (points * problem().amplitude);
  return {scaled(scale, sum.stress), scaled(scale, sum.strain)};
}

template class Classical<2>;
template class Classical<3>;

}  // namespace breccia::dynamics
