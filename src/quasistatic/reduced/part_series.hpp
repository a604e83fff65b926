#pragma once

#include <span>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// The relaxation moduli that belong to the parameters p_i of a response, by part, for these materials of the varying
/// phases. The pointers refer to the materials. Throws InputError when the numbers of materials and of varying phases
/// differ.
[[nodiscard]] std::vector<const PronySeries*> series_of_parts(const ReducedResponse& response,
                                                              std::span<const Material> of_phases);

}  // namespace breccia::quasistatic
