#pragma once

#include <span>

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// The forces K u of a box of cubes, row by row, as forces_under() for squares. Several threads find them, with bitwise
/// identical results for any number of threads.
[[nodiscard]] Forces forces_under(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli,
                                  const Displacement& displacement, const Strain<3>& macroscopic_strain = {});

/// The moduli of the cells of this process after the elimination of the strains of phases, for moduli [Pa] by material.
/// The result refers to the operator.
[[nodiscard]] CellModuli condensed_cells(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli);

}  // namespace breccia::quasistatic
