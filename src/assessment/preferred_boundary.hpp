#pragma once

#include <algorithm>
#include <vector>

#include "breccia/discretisation/boundary.hpp"

namespace breccia {

/// The boundary whose moduli are taken for those of a composite, of those under which it was tested: the periodic one,
/// or else the first.
[[nodiscard]] inline Boundary preferred_boundary(const std::vector<Boundary>& tested) {
  const bool is_periodic = std::ranges::find(tested, Boundary::periodic) != tested.end();
  return is_periodic ? Boundary::periodic : tested.front();
}

}  // namespace breccia
