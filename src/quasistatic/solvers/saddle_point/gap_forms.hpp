#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "breccia/discretisation/phase.hpp"

#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"
#include "quasistatic/solvers/saddle_point/linear_forms.hpp"

namespace breccia::quasistatic {

/// Energies per volume of a cell: half of the shear modulus of a phase, times a factor, times the square of a form.
struct SquareTerms {
  LinearForms forms;
  std::vector<PhaseIndex> phases;     ///< by form
  std::vector<double> factors;        ///< by form
  std::vector<std::size_t> of_plane;  ///< first form by plane of cells, and their number

  [[nodiscard]] std::size_t count() const noexcept { return phases.size(); }
};

/// What cells with gaps (GapCell) have beyond the stiffness of their nodes, as forms of the entries of a field:
/// components of nodal displacements, then the values of gaps (GapLayout), then the pressures of cells. All cells of
/// the box are on this process.
struct GapForms {
  GapForms(const ElasticOperator<3>& elastic_operator, const NodeLattice& lattice);

  SquareTerms slopes;  ///< the ties of the slopes
  SquareTerms flows;
  LinearForms volumes;                ///< volume changes of the cells with gaps
  std::vector<std::uint32_t> cells;   ///< the places of these cells among all cells
  std::vector<std::size_t> of_plane;  ///< first of these cells by plane of cells, and their number
};

}  // namespace breccia::quasistatic
