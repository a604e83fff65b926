#include "quasistatic/operator/square_forces.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/sum_over_cells.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {

Forces forces_under(const ElasticOperator<2>& elastic_operator, std::span<const Moduli> moduli,
                    const Displacement& displacement, const Strain<2>& macroscopic_strain) {
  using Shape = CellShape<2>;
  using CellValues = typename Shape::Values;
  const auto& nodes = elastic_operator.nodes();
  const auto& kinds = elastic_operator.kinds();
  const auto& modes = elastic_operator.modes();
  const auto& layout = elastic_operator.gap_layout();
  const auto by_kind = kinds.stiffnesses(moduli);
  const CellValues unit = Shape::affine_motion(macroscopic_strain);
  const CellValues affine = displacement.macroscopic() * unit;
  // The force conjugate to the macroscopic part is (E x)' k u = (k E x)' u, since the stiffness k of a cell is
  // symmetric.
  std::vector<CellValues> conjugate;
  conjugate.reserve(by_kind.size());
  for (const auto& stiffness : by_kind) conjugate.emplace_back(stiffness * unit);
  const auto local = nodes.local_copy(displacement.fluctuation());
  const ReadValues values(local.get()), strains(displacement.phase_strains());
  const typename Shape::ModeValues unit_modes = modes * unit;
  std::vector<double> on_strains, on_gaps(layout.seen(), 0.0);
  const auto of_gaps = layout.values(displacement.fluctuation());
  auto sum = sum_over_cells(nodes, [&](const Index<2>& cell) {
    const CellValues u = affine + nodes.cell_values(cell, values.data());
    const auto* mixed = kinds.mixed_cell(cell);
    if (mixed == nullptr) {
      const auto kind = kinds.of(cell);
      return std::pair<CellValues, double>(by_kind[kind] * u, conjugate[kind].dot(u));
    }
    if (const auto* gap = elastic_operator.gap_cell(cell)) {
      const GapOperator<2> gap_operator(*gap, modes);
      const auto unknowns = gap_operator.unknowns(u, layout, of_gaps);
      const auto [stress, forces] =
          mixed->stresses(moduli, gap_operator.strain(unknowns), strains.range(on_strains.size(), mixed->unknowns()));
      on_strains.insert(on_strains.end(), forces.begin(), forces.end());
      auto on_unknowns = gaps::CellUnknowns<2>::Zero().eval();
      gap_operator.add_forces_of(stress, on_unknowns);
      gap_operator.add_forces_of_terms(moduli, unknowns, on_unknowns);
      gap_operator.add_to_gaps(on_unknowns, layout, on_gaps);
      const CellValues of_cell = on_unknowns.head<Shape::dofs>();
      return std::pair<CellValues, double>(of_cell, unit.dot(of_cell));
    }
    const auto [stress, forces] =
        mixed->stresses(moduli, modes * u, strains.range(on_strains.size(), mixed->unknowns()));
    on_strains.insert(on_strains.end(), forces.begin(), forces.end());
    return std::pair<CellValues, double>(modes.transpose() * stress, unit_modes.dot(stress));
  });
  layout.add(std::move(on_gaps), sum.on_nodes.get());
  auto on_phase_strains = elastic_operator.zero_strains_of_phases();
  std::ranges::copy(on_strains, WriteValues(on_phase_strains.get()).data());
  return {sum.macroscopic, std::move(sum.on_nodes), std::move(on_phase_strains)};
}

}  // namespace breccia::quasistatic
