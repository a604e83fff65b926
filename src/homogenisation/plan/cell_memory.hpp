#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// Whether a stage is expected to have flow through gaps. Before the packing only the gap that the deck asks for is
/// known.
bool is_expected_to_have_flow(const Study& study, const Stage& stage);

/// Approximate number of unknown displacements of a quasi-static test on a grid with `cells` cells per side.
double quasistatic_unknowns(const Study& study, const Stage& stage, int cells);

/// Upper limit of the share of mixed cells, which interfaces cross, in a grid with `cells` cells per side [-].
double share_of_mixed_cells(const Study& study, const Stage& stage, int cells);

/// Approximate memory [B] of the program in a quasi-static test of a stage on a grid with `cells` cells per side; an
/// empirical formula.
double quasistatic_memory(const Study& study, const Stage& stage, int cells);

}  // namespace breccia
