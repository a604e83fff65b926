#pragma once

#include <string>

#include "breccia/checkpoint/state.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia {

/// Writes a reduced response to a group of a state.
void save(StateWriter& state, const std::string& group, const ReducedResponse& response);
/// Reads it from there. Throws FileError when the group does not hold one.
ReducedResponse read_response(const StateReader& state, const std::string& group);

}  // namespace breccia
