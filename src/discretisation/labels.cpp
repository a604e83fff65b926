#include "breccia/discretisation/labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "breccia/discretisation/mixed_cells.hpp"
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
  const std::vector<int>& count(const Vector<2>& corner, double side) {
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
      counts_[place.phase] += parts * parts;
      return;
    }
    for (const double y : {corner[1], corner[1] + half}) {
      for (const double x : {corner[0], corner[0] + half}) count({x, y}, half, parts / 2);
    }
  }

  const Labelling<2>& labelling_;
  std::vector<int> counts_;
};

/// The shares in steps: those of all phases but the largest are rounded, and that one has the rest.
CellContent content_of(const std::vector<int>& counts) {
  constexpr double steps_per_part = static_cast<double>(mixture_steps) / (label_subdivisions * label_subdivisions);
  const auto largest = std::ranges::max_element(counts) - counts.begin();
  CellContent content;
  int rest = mixture_steps;
  for (std::size_t phase = 0; phase < counts.size(); ++phase) {
    const int steps = static_cast<int>(std::lround(steps_per_part * counts[phase]));
    if (static_cast<std::ptrdiff_t>(phase) == largest) {
      content.emplace_back(static_cast<PhaseIndex>(phase), 0);
    } else if (steps > 0) {
      content.emplace_back(static_cast<PhaseIndex>(phase), steps);
      rest -= steps;
    }
  }
  std::ranges::find(content, static_cast<PhaseIndex>(largest), &CellContent::value_type::first)->second = rest;
  return content;
}

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
    numbers.fill(cell, content_of(parts.count(corner, grid.cell_side)));
  });
  return discretisation;
}

template Discretisation<2> discretise(const Grid<2>&, const Labelling<2>&);
template Discretisation<3> discretise(const Grid<3>&, const Labelling<3>&);

}  // namespace breccia
