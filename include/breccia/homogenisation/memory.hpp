#pragma once

#include <string>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A study will take more memory than there is.
class LackingMemory : public InputError {
 public:
  using InputError::InputError;
};

/// Approximate number of unknown displacements of a quasi-static test on a grid with `cells` cells per side.
double quasistatic_unknowns(const Stage& stage, int cells);

/// Approximate memory [B] of a quasi-static test of a stage on a grid with `cells` cells per side; an empirical
/// formula.
double quasistatic_memory(const Study& study, const Stage& stage, int cells);

/// A message for every stage and method that needs more than the available memory [B], with the number of cells, or of
/// grains with films, that would fit. It assumes a single process.
std::vector<std::string> lacking_memory(const Study& study, double available);

/// Throws LackingMemory with those lines, if there are any.
void require_memory(const Study& study, double available);

}  // namespace breccia
