#pragma once

#include <string>

#include "checkpoint/state.hpp"
#include "quasistatic/operator/displacement.hpp"

namespace breccia::quasistatic {

/// Writes a displacement to a group of a state, in an order that does not depend on the number of processes. Every
/// process must call it.
void save(StateWriter& state, const std::string& group, const Displacement& displacement);
/// Reads the values of a displacement from a group of a state. Throws FileError when the number of nodes differs.
void restore(const StateReader& state, const std::string& group, Displacement& displacement);

}  // namespace breccia::quasistatic
