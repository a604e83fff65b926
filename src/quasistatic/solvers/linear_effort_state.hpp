#pragma once

#include <string>

#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes the effort to a group of a state.
void save(StateWriter& state, const std::string& group, const LinearEffort& effort);
/// Reads the effort from a group of a state. Throws FileError when the group does not hold one.
LinearEffort read_effort(const StateReader& state, const std::string& group);

}  // namespace breccia
