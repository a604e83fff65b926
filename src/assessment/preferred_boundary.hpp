#pragma once

#include <algorithm>
#include <vector>

#include "breccia/discretisation/boundary.hpp"

namespace breccia {

/// The boundary whose moduli are taken for those of a composite, of those of its tests: the periodic one, or else the
/// first. `boundary_of` returns the boundary of a test.
template <class Test, class BoundaryOf>
[[nodiscard]] Boundary preferred_boundary(const std::vector<Test>& tests, const BoundaryOf& boundary_of) {
  const bool is_periodic = std::ranges::find(tests, Boundary::periodic, boundary_of) != tests.end();
  return is_periodic ? Boundary::periodic : boundary_of(tests.front());
}

}  // namespace breccia
