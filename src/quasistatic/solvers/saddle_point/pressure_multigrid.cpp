#include "quasistatic/solvers/saddle_point/pressure_multigrid.hpp"

#include <array>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/operator/matrix_entries.hpp"
#include "quasistatic/solvers/direct/breakdown.hpp"
#include "quasistatic/solvers/direct/solver_options.hpp"
#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

/// Adds 1/k + a/G. The nodes of a cell resist a pressure as the stiffer cells around them do.
void add_compliance_of_cells(const SaddlePointOperator& saddle, MatrixEntries& entries) {
  // For a pressure that varies slowly it is 1/(4/3 + 2/3), for one that alternates much less.
  constexpr double of_shear = 0.1;
  const auto& lattice = saddle.lattice();
  const auto around = shear_around_nodes(lattice, saddle.similar_cells());
  PetscInt index = 0;
  for_each_index(Index<3>{}, lattice.cells, [&](const Index<3>& cell) {
    double of_nodes = 0.0;
    for (int node = 0; node < Shape::nodes; ++node) {
      of_nodes += 1.0 / (Shape::nodes * around[index_of_node(lattice, cell, node)]);
    }
    const auto kind = saddle.kinds()[static_cast<std::size_t>(index)];
    entries.add(index, index, 1.0 / saddle.bulk_of_pressures()[kind] + of_shear * of_nodes);
    ++index;
  });
}

/// Adds B_q diag(H)^-1 B_q'.
void add_conductance_of_flows(const SaddlePointOperator& saddle, MatrixEntries& entries) {
  const auto& resistance = saddle.diagonal_of_flows();
  // The cells on both sides of the face of each flow, with the weights of the flow in their volume changes.
  struct Side {
    PetscInt cell = -1;
    double weight = 0.0;
  };
  std::vector<std::array<Side, 2>> sides(resistance.size());
  const auto& forms = saddle.forms();
  for (std::size_t gap = 0; gap < forms.cells.size(); ++gap) {
    forms.volumes.for_parts(gap, [&](std::size_t entry, double weight) {
      if (entry < saddle.first_gap() || resistance[entry - saddle.first_gap()] == 0.0) return;
      auto& of_flow = sides[entry - saddle.first_gap()];
      of_flow[of_flow[0].cell < 0 ? 0 : 1] = {static_cast<PetscInt>(forms.cells[gap]), weight};
    });
  }
  for (std::size_t flow = 0; flow < sides.size(); ++flow) {
    for (const auto& [cell, weight] : sides[flow]) {
      for (const auto& [other, other_weight] : sides[flow]) {
        if (cell >= 0 && other >= 0) entries.add(cell, other, weight * other_weight / resistance[flow]);
      }
    }
  }
}

}  // namespace

PressureMultigrid::PressureMultigrid(const SaddlePointOperator& saddle)
    : first_pressure_(saddle.first_pressure()), cells_(static_cast<PetscInt>(saddle.cells())) {
  constexpr const char* doing = "setting up multigrid for pressures";
  constexpr const char* prefix = "pressures_";
  MatrixEntries entries;
  add_compliance_of_cells(saddle, entries);
  add_conductance_of_flows(saddle, entries);
  check(MatCreate(PETSC_COMM_SELF, schur_complement_.put()), doing);
  check(MatSetSizes(schur_complement_.get(), cells_, cells_, cells_, cells_), doing);
  check(MatSetType(schur_complement_.get(), MATSEQAIJ), doing);
  check(MatSetPreallocationCOO(schur_complement_.get(), static_cast<PetscCount>(entries.values.size()),
                               entries.rows.data(), entries.columns.data()),
        doing);
  check(MatSetValuesCOO(schur_complement_.get(), entries.values.data(), INSERT_VALUES), doing);
  check(MatSetOption(schur_complement_.get(), MAT_SPD, PETSC_TRUE), doing);

  check(KSPCreate(PETSC_COMM_SELF, solver_.put()), doing);
  check(KSPSetOptionsPrefix(solver_.get(), prefix), doing);
  check(KSPSetType(solver_.get(), KSPPREONLY), doing);
  check(KSPSetOperators(solver_.get(), schur_complement_.get(), schur_complement_.get()), doing);
  PC multigrid = nullptr;
  check(KSPGetPC(solver_.get(), &multigrid), doing);
  check(PCSetType(multigrid, PCGAMG), doing);
  // A symmetric sweep of Gauss and Seidel before and after each level, so that the cycle is symmetric.
  set_default_option(prefix, "mg_levels_ksp_type", KSPRICHARDSON);
  set_default_option(prefix, "mg_levels_ksp_max_it", "1");
  set_default_option(prefix, "mg_levels_pc_type", PCSOR);
  check(KSPSetFromOptions(solver_.get()), doing);
  check(KSPSetUp(solver_.get()), doing);
  require_no_breakdown(solver_.get(),
                       "quasi-static solver: multigrid fails on the pressures in gaps: a modulus may be zero, or the "
                       "contrast beyond what numbers hold");
}

void PressureMultigrid::apply(const NodalField& right, NodalField& solution) const {
  constexpr const char* doing = "finding pressures by multigrid";
  NodalVector volumes, pressures;
  const auto at = static_cast<std::ptrdiff_t>(first_pressure_);
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, cells_, right.all().data() + at, volumes.put()), doing);
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, cells_, solution.all().data() + at, pressures.put()), doing);
  check(KSPSolve(solver_.get(), volumes.get(), pressures.get()), doing);
}

}  // namespace breccia::quasistatic
