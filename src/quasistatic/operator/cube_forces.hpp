#pragma once

#include <span>

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// K u of a box of cubes, row by row, as forces_under() of squares. By several threads, with the same bits for any
/// number of them.
[[nodiscard]] Forces forces_under(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli,
                                  const Displacement& displacement, const Strain<3>& macroscopic_strain = {});

/// The moduli of the cells of this process where the strains of phases have been eliminated, for moduli [Pa] by
/// material. Refers to the operator.
[[nodiscard]] CellModuli condensed_cells(const ElasticOperator<3>& elastic_operator, std::span<const Moduli> moduli);

}  // namespace breccia::quasistatic
