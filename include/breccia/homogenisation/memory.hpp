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

/// Memory [B] that a quasi-static test takes, about: from experience, with all that it keeps.
double quasistatic_memory(const Study& study, const Stage& stage, int cells);

/// A line for every stage and method that will take more memory [B] than there is, with the number of cells that would
/// fit. Of a process alone; several may be on several machines.
std::vector<std::string> lacking_memory(const Study& study, double available);

/// Throws LackingMemory with those lines, if there are any.
void require_memory(const Study& study, double available);

}  // namespace breccia
