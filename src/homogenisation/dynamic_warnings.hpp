#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/study/study.hpp"
#include "breccia/virtual_test/time_domain.hpp"

namespace breccia {

/// A warning where a box with free boundaries still rings after its ramp, so that its modulus may be that of its
/// inertia; nothing where the ramp is given as a time, whose number of transits only a run shows.
std::optional<std::string> warning_of_ringing(const Tests& tests);

/// Warnings on the time domains of a dynamic test: the same where the ramp is given as a time, and on Prony terms that
/// were left out and may matter.
std::vector<std::string> warnings_on_domains(const Tests& tests, Boundary boundary,
                                             const std::vector<TimeDomain>& domains);

}  // namespace breccia
