#pragma once

#include <string>

#include "breccia/quasistatic/reduced_response.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Writes a reduced response to a group of a state.
void save(StateWriter& state, const std::string& group, const ReducedResponse& response);
/// Reads a reduced response from a group of a state. Throws FileError when the group does not hold one.
ReducedResponse read_response(const StateReader& state, const std::string& group);

}  // namespace breccia
