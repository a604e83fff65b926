#pragma once

#include <string>

#include "breccia/checkpoint/state.hpp"

#include "operator/displacement.hpp"

namespace breccia::quasistatic {

/// Writes a displacement to a group of a state. Every process must call it.
void save(StateWriter& state, const std::string& group, const Displacement& displacement);
/// Reads the values of a displacement from a group of a state. Throws FileError when the number of nodes differs.
void restore(const StateReader& state, const std::string& group, Displacement& displacement);

/// Throws InputError when the state was written by another number of processes: the last digits of parallel sums
/// depend on that number, so a run can only be continued with the same one.
void require_as_many_processes(const StateReader& state);

}  // namespace breccia::quasistatic
