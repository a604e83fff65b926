#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// Approximate number of unknown displacements of a quasi-static test on a grid with `cells` cells per side.
double quasistatic_unknowns(int cells);

/// Approximate memory [B] of a quasi-static test of a stage on a grid with `cells` cells per side; an empirical
/// formula.
double quasistatic_memory(const Study& study, const Stage& stage, int cells);

/// Memory [B] that this process may still allocate: the smallest of the free memory of the machine, the limits of its
/// control groups and that of `ulimit -v`; infinite if none of them can be read.
double available_memory();

/// A message for every stage and method that needs more than the available memory [B], with the number of cells that
/// would fit. It assumes a single process.
std::vector<std::string> lacking_memory(const Study& study, double available);

/// Throws InputError with the lines of lacking_memory(), if there are any.
void require_memory(const Study& study, double available);

}  // namespace breccia
