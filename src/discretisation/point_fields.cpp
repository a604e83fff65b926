#include "breccia/discretisation/point_fields.hpp"

#include <algorithm>

namespace breccia {
namespace {

PhaseIndex largest_part(const Mixture& mixture) {
  return std::ranges::max_element(mixture, {}, &MixedPart::fraction)->phase;
}

}  // namespace

template <int dim>
PointFields<dim> zero_fields(const Discretisation<dim>& discretisation) {
  const auto& grid = discretisation.grid();
  const auto points = discretisation.points();
  PointFields<dim> fields;
  fields.phase.resize(points);
  fields.displacement.resize(points);
  fields.strain.resize(points);
  fields.stress.resize(points);
  grid.for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    for (int p = 0; p < Discretisation<dim>::points_per_cell; ++p) {
      const auto phase = phases[static_cast<std::size_t>(p)];
      const auto* mixture = discretisation.mixture(phase);
      fields.phase[grid.point_index(cell, p)] = mixture == nullptr ? phase : largest_part(*mixture);
    }
  });
  return fields;
}

template PointFields<2> zero_fields(const Discretisation<2>&);
template PointFields<3> zero_fields(const Discretisation<3>&);

}  // namespace breccia
