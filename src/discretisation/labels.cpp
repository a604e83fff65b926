#include "discretisation/labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/mixture_numbers.hpp"

namespace breccia {
namespace {

/// Parts of a cell along each axis.
template <int dim>
constexpr int subdivisions = dim == 2 ? label_subdivisions : cube_label_subdivisions;

/// Counts the parts of a cell by phase. A square (cube) of parts that contains no interface is counted as a whole; any
/// other is divided into four (eight).
template <int dim>
class PartCounter {
 public:
  PartCounter(const Labelling<dim>& labelling, std::size_t phases) : labelling_(labelling), counts_(phases) {}

  /// Parts of each phase in the cell with this lower corner and side [m], by PhaseIndex.
  const std::vector<std::int64_t>& count(const Vector<dim>& corner, double side) {
    std::ranges::fill(counts_, 0);
    count(corner, side, subdivisions<dim>);
    return counts_;
  }

 private:
  /// `parts` is the number of parts along each side of the square or cube.
  void count(const Vector<dim>& corner, double side, int parts) {
    const double half = 0.5 * side;
    auto centre = corner;
    for (double& x : centre) x += half;
    const auto found = labelling_(centre);
    if (parts == 1 || found.clearance > std::sqrt(static_cast<double>(dim)) * half) {
      if (found.phase >= counts_.size()) {
        throw InputError(fmt::format("discretisation: a phase has the number {}, counted from 0, but there are only {}",
                                     found.phase, counts_.size()));
      }
      std::int64_t all = 1;
      for (int axis = 0; axis < dim; ++axis) all *= parts;
      counts_[found.phase] += all;
      return;
    }
    Index<dim> two{};
    two.fill(2);
    for_each_index(Index<dim>{}, two, [&](const Index<dim>& part) {
      auto lower = corner;
      for (std::size_t axis = 0; axis < lower.size(); ++axis) lower[axis] += part[axis] * half;
      count(lower, half, parts / 2);
    });
  }

  const Labelling<dim>& labelling_;
  std::vector<std::int64_t> counts_;
};

template <int dim>
Discretisation<dim> mixed_cells_of(const Grid<dim>& grid, const Labelling<dim>& labelling, std::size_t phases,
                                   const CellLayers& layers) {
  Discretisation<dim> discretisation(grid, 0, layers);
  MixtureNumbers<dim> numbers(discretisation, phases);
  PartCounter<dim> parts(labelling, phases);
  const auto& [begin, end] = discretisation.range();
  for_each_index(begin, end, [&](const Index<dim>& cell) {
    Vector<dim> corner{};
    for (std::size_t axis = 0; axis < corner.size(); ++axis) corner[axis] = cell[axis] * grid.cell_side;
    numbers.fill(cell, rounded_content(parts.count(corner, grid.cell_side)));
  });
  return discretisation;
}

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Grid<dim>& grid, const Labelling<dim>& labelling, const CellLayers& layers) {
  Discretisation<dim> discretisation(grid, 0, layers);
  discretisation.label([&](const Vector<dim>& position) { return labelling(position).phase; });
  return discretisation;
}

Discretisation<2> discretise_mixed(const Grid<2>& grid, const Labelling<2>& labelling, std::size_t phases,
                                   const CellLayers& layers) {
  return mixed_cells_of(grid, labelling, phases, layers);
}

Discretisation<3> discretise_mixed(const Grid<3>& grid, const Labelling<3>& labelling, std::size_t phases,
                                   const CellLayers& layers) {
  return mixed_cells_of(grid, labelling, phases, layers);
}

template Discretisation<2> discretise(const Grid<2>&, const Labelling<2>&, const CellLayers&);
template Discretisation<3> discretise(const Grid<3>&, const Labelling<3>&, const CellLayers&);

}  // namespace breccia
