#pragma once

#include <string>

#include "breccia/quasistatic/reduced_response.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Reads a load, or a pair of loads, from the number that it was written as. Throws FileError for another number.
Load read_load(const StateReader& state, const std::string& name);

/// Writes a reduced response to a group of a state.
void save(StateWriter& state, const std::string& group, const ReducedResponse& response);
/// Reads a reduced response from a group of a state. Throws FileError when the group does not hold one.
ReducedResponse read_response(const StateReader& state, const std::string& group);

}  // namespace breccia
