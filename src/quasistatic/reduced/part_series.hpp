#pragma once

#include <span>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// The moduli in time that the parameters p_i of a response are, by part, for materials of the phases that vary. They
/// point to the materials. Throws InputError when the materials are not as many as the phases.
[[nodiscard]] std::vector<const PronySeries*> series_of_parts(const ReducedResponse& response,
                                                              std::span<const Material> of_phases);

}  // namespace breccia::quasistatic
