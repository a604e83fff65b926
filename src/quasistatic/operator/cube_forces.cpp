#include "quasistatic/operator/cube_forces.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/halo_field.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// The moduli of the cells of this process; of_kind(kind) returns those of a kind of cells of one material or mixture.
template <class OfKind>
CellModuli moduli_of_cells(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli,
                           const OfKind& of_kind) {
  constexpr auto none = static_cast<std::uint32_t>(-1);
  const auto& kinds = elastic_operator.kinds();
  CellModuli cells;
  std::vector<std::uint32_t> other;  // index of the stiffness of the other cells, by kind
  for (std::size_t kind = 0; kind < kinds.count(); ++kind) {
    const auto uniform = of_kind(kind);
    const auto [bulk, shear] = uniform.value_or(Moduli{.bulk = 0.0, .shear = 0.0});
    cells.shear.push_back(shear);
    cells.bulk.push_back(bulk);
    other.push_back(uniform ? none : static_cast<std::uint32_t>(cells.stiffnesses.size()));
    if (!uniform) cells.stiffnesses.push_back(kinds.stiffness(kind, moduli));
  }
  const auto& own = elastic_operator.nodes().cells();
  const auto size = own.size();
  const auto row = static_cast<std::size_t>(size[0]);
  cells.kind_of = {kinds.of_cells().data(), row, row * static_cast<std::size_t>(size[1])};
  if (cells.stiffnesses.empty()) return cells;
  elastic_operator.nodes().for_cells([&](const Index<3>& cell) {
    const auto kind = kinds.of(cell);
    if (other[kind] == none) return;
    auto among_own = cell;
    for (std::size_t axis = 0; axis < among_own.size(); ++axis) among_own[axis] -= own.begin[axis];
    cells.others.push_back({among_own, other[kind]});
  });
  return cells;
}

/// Adds the forces of the mixed cells on their nodes and gaps, and sets the forces on the strains of their phases.
class MixedForces {
 public:
  MixedForces(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli, const HaloField& moved,
              std::span<const double> of_gaps)
      : operator_(elastic_operator), moduli_(moduli), moved_(moved), of_gaps_(of_gaps) {}

  void add(const Displacement& displacement, const CellSweep& sweep, HaloField& exerted, Vec on_phase_strains,
           std::span<double> on_gaps) const {
    const ReadValues strains(displacement.phase_strains());
    const WriteValues on_strains(on_phase_strains);
    sweep.for_slabs(operator_.threads(), [&](int, int first_plane, int end_plane) {
      operator_.for_mixed_cells_of_planes(
          first_plane, end_plane, [&](const Index<3>& cell, const MixedCell<3>& mixed, std::size_t index) {
            const auto unknown = strains.range(index, mixed.unknowns());
            const auto on_unknown = on_strains.range(index, mixed.unknowns());
            const auto nodes = nodes_of(cell);
            const auto* gap = operator_.gap_cell(cell);
            const auto forces = gap != nullptr
                                    ? of_gap_cell(*gap, mixed, values_at(nodes), unknown, on_unknown, on_gaps)
                                    : of_cell(mixed, values_at(nodes), unknown, on_unknown);
            add_to(nodes, forces, exerted);
          });
    });
  }

 private:
  using Nodes = std::array<std::size_t, Shape::nodes>;
  using Values = typename Shape::Values;
  using OnUnknown = Eigen::Map<Eigen::VectorXd>;

  [[nodiscard]] Nodes nodes_of(const Index<3>& cell) const noexcept {
    Nodes nodes{};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      auto node = Shape::corner(static_cast<int>(n));
      for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] += cell[axis];
      nodes[n] = moved_.index_of(node);
    }
    return nodes;
  }
  [[nodiscard]] Values values_at(const Nodes& nodes) const noexcept {
    const auto displacements = moved_.from(0);
    Values u;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (std::size_t i = 0; i < 3; ++i) u[static_cast<Eigen::Index>(3 * n + i)] = displacements[i][nodes[n]];
    }
    return u;
  }
  static void add_to(const Nodes& nodes, const Values& forces, HaloField& exerted) noexcept {
    const auto forces_on = exerted.from(0);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (std::size_t i = 0; i < 3; ++i) forces_on[i][nodes[n]] += forces[static_cast<Eigen::Index>(3 * n + i)];
    }
  }

  [[nodiscard]] Values of_cell(const MixedCell<3>& mixed, const Values& u, const MixedCell<3>::Strains& unknown,
                               OnUnknown on_unknown) const {
    const auto& modes = operator_.modes();
    const auto [stress, on_phases] = mixed.stresses(moduli_, modes * u, unknown);
    on_unknown = on_phases;
    return modes.transpose() * stress;
  }
  [[nodiscard]] Values of_gap_cell(const gaps::GapCell<3>& cell, const MixedCell<3>& mixed, const Values& u,
                                   const MixedCell<3>::Strains& unknown, OnUnknown on_unknown,
                                   std::span<double> on_gaps) const {
    const GapOperator<3> gap(cell, operator_.modes());
    const auto unknowns = gap.unknowns(u, operator_.gap_layout(), of_gaps_);
    const auto [stress, on_phases] = mixed.stresses(moduli_, gap.strain(unknowns), unknown);
    on_unknown = on_phases;
    auto forces = gaps::CellUnknowns<3>::Zero().eval();
    gap.add_forces_of(stress, forces);
    gap.add_forces_of_terms(moduli_, unknowns, forces);
    gap.add_to_gaps(forces, operator_.gap_layout(), on_gaps);
    return forces.head<Shape::dofs>();
  }

  const ElasticOperator<3>& operator_;
  std::span<const Moduli> moduli_;
  const HaloField& moved_;
  std::span<const double> of_gaps_;
};

/// The sweep over mixed cells. Where one process has a whole periodic box, the gaps at its upper end are those at its
/// lower one, though their nodes have entries of their own: the last slab is then a neighbour of the first.
CellSweep sweep_over_gaps(const ElasticOperator<3>& elastic_operator, NodeArrays arrays) {
  const auto size = elastic_operator.nodes().cells().size();
  const bool is_whole = size[2] == elastic_operator.grid().cells[2];
  const bool wraps = is_whole && elastic_operator.boundary() == Boundary::periodic;
  if (elastic_operator.has_gaps() && wraps) arrays.nodes[2] = size[2];
  return {size, arrays};
}

}  // namespace

CellModuli condensed_cells(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli) {
  const auto& kinds = elastic_operator.kinds();
  return moduli_of_cells(elastic_operator, moduli,
                         [&](std::size_t kind) { return kinds.uniform_moduli(kind, moduli); });
}

/// Finds the forces of all cells except the mixed ones row by row, then those of the mixed cells. Memory that is not
/// needed any longer is freed on the way, because it is short where this function is called.
Forces forces_under(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli,
                    const Displacement& displacement, const Strain<3>& macroscopic_strain) {
  const auto& nodes = elastic_operator.nodes();
  const auto& kinds = elastic_operator.kinds();
  const int threads = elastic_operator.threads();
  std::optional<HaloField> moved(std::in_place, nodes, threads), exerted;
  moved->read(nodes, displacement.fluctuation(), displacement.macroscopic(), macroscopic_strain);
  exerted.emplace(nodes, threads);

  const auto cells = moduli_of_cells(elastic_operator, moduli, [&](std::size_t kind) {
    return kinds.mixed()[kind] ? std::optional<Moduli>(Moduli{.bulk = 0.0, .shear = 0.0})
                               : kinds.uniform_moduli(kind, moduli);
  });
  const CellSweep sweep(nodes.cells().size(), moved->arrays());
  const auto first = moved->index_of(nodes.cells().begin);
  sweep.add_forces(cells, std::as_const(*moved).from(first), exerted->from(first), threads);
  auto on_phase_strains = elastic_operator.zero_strains_of_phases();
  const auto& layout = elastic_operator.gap_layout();
  const auto of_gaps = layout.values(displacement.fluctuation());
  std::vector<double> on_gaps(layout.seen(), 0.0);
  MixedForces(elastic_operator, moduli, *moved, of_gaps)
      .add(displacement, sweep_over_gaps(elastic_operator, moved->arrays()), *exerted, on_phase_strains.get(), on_gaps);
  moved.reset();

  double macroscopic = exerted->work_on(macroscopic_strain);
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  auto on_nodes = nodes.zeros();
  exerted->sum_up(nodes, on_nodes.get());
  layout.add(std::move(on_gaps), on_nodes.get());
  return {macroscopic, std::move(on_nodes), std::move(on_phase_strains)};
}

}  // namespace breccia::quasistatic
