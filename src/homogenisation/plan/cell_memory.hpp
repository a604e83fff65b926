#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// Approximate number of unknown displacements of a quasi-static test on a grid with `cells` cells per side.
double quasistatic_unknowns(const Stage& stage, int cells);

/// Share of the cells of a grid with `cells` cells per side that interfaces cross and that are mixed [-], at most.
double share_of_mixed_cells(const Study& study, const Stage& stage, int cells);

/// Approximate memory [B] that the program has in a quasi-static test of a stage on such a grid; an empirical formula.
double quasistatic_memory(const Study& study, const Stage& stage, int cells);

}  // namespace breccia
