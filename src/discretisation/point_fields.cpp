#include "breccia/discretisation/point_fields.hpp"

#include <algorithm>
#include <cstddef>

namespace breccia {
namespace {

PhaseIndex largest_part(const Mixture& mixture) {
  return std::ranges::max_element(mixture, {}, &MixedPart::fraction)->phase;
}

/// The phase of a point, of a mixture its largest part.
template <int dim>
PhaseIndex phase_at(const Discretisation<dim>& discretisation, PhaseIndex phase) {
  const auto* mixture = discretisation.mixture(phase);
  return mixture == nullptr ? phase : largest_part(*mixture);
}

template <int dim>
LatticeFields<dim> zero_lattice(std::size_t size) {
  LatticeFields<dim> fields;
  fields.phase.resize(size);
  fields.displacement.resize(size);
  fields.strain.resize(size);
  fields.stress.resize(size);
  return fields;
}

}  // namespace

template <int dim>
PointFields<dim> zero_fields(const Discretisation<dim>& discretisation) {
  const auto& grid = discretisation.grid();
  auto fields = zero_lattice<dim>(discretisation.points());
  grid.for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    for (int p = 0; p < Discretisation<dim>::points_per_cell; ++p) {
      fields.phase[grid.point_index(cell, p)] = phase_at(discretisation, phases[static_cast<std::size_t>(p)]);
    }
  });
  return fields;
}

template <int dim>
CellFields<dim> zero_cell_fields(const Discretisation<dim>& discretisation) {
  const auto& grid = discretisation.grid();
  auto fields = zero_lattice<dim>(grid.cell_count());
  grid.for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    const auto points_of = [&phases](PhaseIndex phase) { return std::ranges::count(phases, phase); };
    fields.phase[grid.cell_index(cell)] = phase_at(discretisation, *std::ranges::max_element(phases, {}, points_of));
  });
  return fields;
}

template <int dim>
LatticeFields<dim> zero_timed_fields(const Discretisation<dim>& discretisation) {
  if constexpr (dim == 2) {
    return zero_fields(discretisation);
  } else {
    return zero_cell_fields(discretisation);
  }
}

template PointFields<2> zero_fields(const Discretisation<2>&);
template PointFields<3> zero_fields(const Discretisation<3>&);
template CellFields<2> zero_cell_fields(const Discretisation<2>&);
template CellFields<3> zero_cell_fields(const Discretisation<3>&);
template LatticeFields<2> zero_timed_fields(const Discretisation<2>&);
template LatticeFields<3> zero_timed_fields(const Discretisation<3>&);

}  // namespace breccia
