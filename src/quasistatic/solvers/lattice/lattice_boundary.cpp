#include "quasistatic/solvers/lattice/lattice_boundary.hpp"

#include <algorithm>

#include "parallel/reduction.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {

std::size_t LatticeBoundary::corner(std::size_t axis) const noexcept {
  Index<3> node{};
  node[axis] = lattice_.cells[axis];
  return lattice_.index_of(node);
}

/// Calls work(second index, third index, index of the first node) for all rows of nodes of this process.
template <class Work>
void LatticeBoundary::for_rows(const Work& work) const {
  for (int plane = 0; plane < lattice_.planes; ++plane) {
    for (int second = 0; second < lattice_.nodes[1]; ++second) {
      work(second, lattice_.first_plane + plane, lattice_.index_of({0, second, plane}));
    }
  }
}

void LatticeBoundary::read(Vec nodal, NodalField& field) const {
  const ReadValues values(nodal);
  const double* value = values.data();
  const auto components = field.components();
  for_rows([&](int, int, std::size_t index) {
    for (int first = 0; first < lattice_.nodes[0]; ++first, ++index) {
      for (double* component : components) component[index] = *value++;
    }
  });
}

void LatticeBoundary::write(const NodalField& field, Vec nodal) const {
  const WriteValues values(nodal);
  double* value = values.data();
  const auto components = field.components();
  for_rows([&](int, int, std::size_t index) {
    for (int first = 0; first < lattice_.nodes[0]; ++first, ++index) {
      for (const double* component : components) *value++ = component[index];
    }
  });
}

void LatticeBoundary::balance(NodalField& forces) const {
  if (lattice_.boundary == Boundary::displacement) return;
  const auto components = forces.components();
  double *x = components[0], *y = components[1], *z = components[2];
  std::array<double, 3> sum{}, moment{};
  for_rows([&](int second, int third, std::size_t index) {
    for (int first = 0; first < lattice_.nodes[0]; ++first, ++index) {
      sum[0] += x[index];
      sum[1] += y[index];
      sum[2] += z[index];
      moment[0] += second * z[index] - third * y[index];
      moment[1] += third * x[index] - first * z[index];
      moment[2] += first * y[index] - second * x[index];
    }
  });
  for (double& of_all : sum) of_all = parallel::sum(of_all);
  for (double& of_all : moment) of_all = parallel::sum(of_all);
  if (!has_corners()) return;
  if (lattice_.boundary == Boundary::traction) {
    const double y_on_first = -moment[2] / lattice_.cells[0], z_on_first = moment[1] / lattice_.cells[0],
                 z_on_second = -moment[0] / lattice_.cells[1];
    y[corner(0)] += y_on_first;
    z[corner(0)] += z_on_first;
    z[corner(1)] += z_on_second;
    sum[1] += y_on_first;
    sum[2] += z_on_first + z_on_second;
  }
  x[0] -= sum[0];
  y[0] -= sum[1];
  z[0] -= sum[2];
}

void LatticeBoundary::settle(NodalField& displacement) const {
  if (lattice_.boundary == Boundary::displacement) return;
  const auto components = displacement.components();
  double *x = components[0], *y = components[1], *z = components[2];
  std::array<double, 3> shift{}, rotation{};
  if (has_corners()) shift = {x[0], y[0], z[0]};
  if (has_corners() && lattice_.boundary == Boundary::traction) {
    rotation = {(z[corner(1)] - shift[2]) / lattice_.cells[1], (shift[2] - z[corner(0)]) / lattice_.cells[0],
                (y[corner(0)] - shift[1]) / lattice_.cells[0]};
  }
  for (double& of_all : shift) of_all = parallel::sum(of_all);
  for (double& of_all : rotation) of_all = parallel::sum(of_all);
  for_rows([&](int second, int third, std::size_t index) {
    for (int first = 0; first < lattice_.nodes[0]; ++first, ++index) {
      x[index] -= shift[0] + rotation[1] * third - rotation[2] * second;
      y[index] -= shift[1] + rotation[2] * first - rotation[0] * third;
      z[index] -= shift[2] + rotation[0] * second - rotation[1] * first;
    }
  });
}

void LatticeBoundary::repeat_first_nodes(NodalField& displacement) const {
  if (lattice_.is_periodic()) {
    const auto behind = static_cast<std::size_t>(lattice_.cells[0]);
    for (double* component : displacement.components()) {
      for_rows([&](int, int, std::size_t index) { component[index + behind] = component[index]; });
    }
  }
  exchange_.copy_from_above(displacement);
}

void LatticeBoundary::collect(NodalField& forces) {
  exchange_.add_to_above(forces);
  const auto last = static_cast<std::size_t>(lattice_.cells[0]);
  for (double* component : forces.components()) {
    for_rows([&](int second, int third, std::size_t index) {
      double* row = component + index;
      if (lattice_.is_periodic()) {
        row[0] += row[last];
        row[last] = 0.0;
      } else if (lattice_.boundary == Boundary::displacement) {
        const bool is_on_wall = second == 0 || second == lattice_.cells[1] || third == 0 || third == lattice_.cells[2];
        if (is_on_wall) std::fill(row, row + last, 0.0);
        row[0] = row[last] = 0.0;
      }
    });
  }
}

}  // namespace breccia::quasistatic
