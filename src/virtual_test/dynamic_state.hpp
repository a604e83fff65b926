#pragma once

#include <string>
#include <vector>

#include "checkpoint/state.hpp"
#include "virtual_test/dynamic_test.hpp"

namespace breccia {

/// Writes one time domain, with its history, to a group of a state, or reads it from there.
void save_domain(StateWriter& state, const std::string& group, const TimeDomain& domain);
TimeDomain read_domain(const StateReader& state, const std::string& group);

/// Writes the finished domains, or reads them.
void save_domains(StateWriter& state, const std::vector<TimeDomain>& domains);
std::vector<TimeDomain> read_domains(const StateReader& state);

}  // namespace breccia
