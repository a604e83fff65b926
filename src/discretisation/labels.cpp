#include "breccia/discretisation/labels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "mixture_numbers.hpp"

namespace breccia {
namespace {

/// Counts the parts of a cell by phase. A square of parts in which no interface can be is counted as a whole, another
/// is divided into four.
class PartCounter {
 public:
  PartCounter(const Labelling<2>& labelling, std::size_t phases) : labelling_(labelling), counts_(phases) {}

  /// Parts of each phase in the cell with this lower corner and side [m], by PhaseIndex.
  const std::vector<std::int64_t>& count(const Vector<2>& corner, double side) {
    std::ranges::fill(counts_, 0);
    count(corner, side, label_subdivisions);
    return counts_;
  }

 private:
  /// `parts` is the number of parts along each side of the square.
  void count(const Vector<2>& corner, double side, int parts) {
    const double half = 0.5 * side;
    const auto place = labelling_({corner[0] + half, corner[1] + half});
    if (parts == 1 || place.clearance > std::numbers::sqrt2 * half) {
      if (place.phase >= counts_.size()) {
        throw InputError(fmt::format("discretisation: a phase has the number {}, counted from 0, but there are only {}",
                                     place.phase, counts_.size()));
      }
      counts_[place.phase] += std::int64_t{parts} * parts;
      return;
    }
    for (const double y : {corner[1], corner[1] + half}) {
      for (const double x : {corner[0], corner[0] + half}) count({x, y}, half, parts / 2);
    }
  }

  const Labelling<2>& labelling_;
  std::vector<std::int64_t> counts_;
};

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Grid<dim>& grid, const Labelling<dim>& labelling) {
  Discretisation<dim> discretisation(grid);
  discretisation.label([&](const Vector<dim>& position) { return labelling(position).phase; });
  return discretisation;
}

Discretisation<2> discretise_mixed(const Grid<2>& grid, const Labelling<2>& labelling, std::size_t phases) {
  Discretisation<2> discretisation(grid);
  MixtureNumbers numbers(discretisation, phases);
  PartCounter parts(labelling, phases);
  grid.for_each_cell([&](const Index<2>& cell) {
    const Vector<2> corner = {cell[0] * grid.cell_side, cell[1] * grid.cell_side};
    numbers.fill(cell, rounded_content(parts.count(corner, grid.cell_side)));
  });
  return discretisation;
}

template Discretisation<2> discretise(const Grid<2>&, const Labelling<2>&);
template Discretisation<3> discretise(const Grid<3>&, const Labelling<3>&);

}  // namespace breccia
