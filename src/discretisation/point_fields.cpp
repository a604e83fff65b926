#include "breccia/discretisation/point_fields.hpp"

#include <algorithm>
#include <cstddef>

namespace breccia {
namespace {

PhaseIndex largest_part(const Mixture& mixture) {
  return std::ranges::max_element(mixture, {}, &MixedPart::fraction)->phase;
}

/// The phase that fields show at a point: for a mixture the phase with the largest share, for a crystal that of its
/// filler.
template <int dim>
PhaseIndex phase_at(const Discretisation<dim>& discretisation, const Crystals& crystals, PhaseIndex phase) {
  if (const auto* mixture = discretisation.mixture(phase)) return largest_part(*mixture);
  const auto crystal = crystals.find(phase);
  return crystal == crystals.end() || crystal->second.shown_as == no_phase ? phase : crystal->second.shown_as;
}

template <int dim>
LatticeFields<dim> zero_lattice(const IndexRange<dim>& cells, std::size_t size) {
  LatticeFields<dim> fields;
  fields.cells = cells;
  fields.phase.resize(size);
  fields.displacement.resize(size);
  fields.strain.resize(size);
  fields.stress.resize(size);
  return fields;
}

template <int dim>
std::size_t count(const IndexRange<dim>& cells) {
  return Grid<dim>{.cells = cells.size()}.cell_count();
}

template <int dim>
PointFields<dim> zero_fields(const Discretisation<dim>& discretisation, const IndexRange<dim>& cells,
                             const Crystals& crystals) {
  constexpr int points = Discretisation<dim>::points_per_cell;
  auto fields = zero_lattice<dim>(cells, points * count(cells));
  const Grid<dim> part = {.cells = cells.size()};
  for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) {
    auto index = cell;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) index[axis] -= cells.begin[axis];
    const auto& phases = discretisation.cell(cell);
    for (int p = 0; p < points; ++p) {
      fields.phase[part.point_index(index, p)] =
          phase_at(discretisation, crystals, phases[static_cast<std::size_t>(p)]);
    }
  });
  return fields;
}

template <int dim>
CellFields<dim> zero_cell_fields(const Discretisation<dim>& discretisation, const IndexRange<dim>& cells,
                                 const Crystals& crystals) {
  auto fields = zero_lattice<dim>(cells, count(cells));
  auto next = fields.phase.begin();
  for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) {
    auto phases = discretisation.cell(cell);
    for (auto& phase : phases) phase = phase_at(discretisation, crystals, phase);
    const auto points_of = [&phases](PhaseIndex phase) { return std::ranges::count(phases, phase); };
    *next++ = *std::ranges::max_element(phases, {}, points_of);
  });
  return fields;
}

}  // namespace

template <int dim>
PointFields<dim> zero_fields(const Discretisation<dim>& discretisation) {
  return zero_fields(discretisation, discretisation.grid().all_cells(), {});
}

template <int dim>
CellFields<dim> zero_cell_fields(const Discretisation<dim>& discretisation) {
  return zero_cell_fields(discretisation, discretisation.grid().all_cells(), {});
}

template <int dim>
LatticeFields<dim> zero_timed_fields(const Discretisation<dim>& discretisation, const IndexRange<dim>& cells,
                                     const Crystals& crystals) {
  if constexpr (dim == 2) {
    return zero_fields(discretisation, cells, crystals);
  } else {
    return zero_cell_fields(discretisation, cells, crystals);
  }
}

template <int dim>
parallel::OrderedPlaces places_of_timed_fields(const Grid<dim>& grid, const IndexRange<dim>& cells) {
  // The lattice of points has two points a cell along each axis.
  const int finer = dim == 2 ? 2 : 1;
  Grid<dim> all = grid, part = {.cells = cells.size()};
  auto begin = cells.begin;
  for (std::size_t axis = 0; axis < begin.size(); ++axis) {
    for (int* along : {&all.cells[axis], &part.cells[axis], &begin[axis]}) *along *= finer;
  }
  const auto place_of = [all, part, begin](std::size_t value) {
    auto index = part.cell_at(value);
    for (std::size_t axis = 0; axis < begin.size(); ++axis) index[axis] += begin[axis];
    return all.cell_index(index);
  };
  return {part.cell_count(), place_of};
}

template PointFields<2> zero_fields(const Discretisation<2>&);
template PointFields<3> zero_fields(const Discretisation<3>&);
template CellFields<2> zero_cell_fields(const Discretisation<2>&);
template CellFields<3> zero_cell_fields(const Discretisation<3>&);
template LatticeFields<2> zero_timed_fields(const Discretisation<2>&, const IndexRange<2>&, const Crystals&);
template LatticeFields<3> zero_timed_fields(const Discretisation<3>&, const IndexRange<3>&, const Crystals&);
template parallel::OrderedPlaces places_of_timed_fields(const Grid<2>&, const IndexRange<2>&);
template parallel::OrderedPlaces places_of_timed_fields(const Grid<3>&, const IndexRange<3>&);

}  // namespace breccia
