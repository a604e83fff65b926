#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia::quasistatic {

/// A composite at one time: its displacement, and the moduli that vary applied to the history of the displacement, the
/// Stieltjes integrals of M(t - t') du(t') [Pa] (theory, Eq. 35).
template <class Vector>
struct CompositeState {
  Vector displacement;
  std::vector<Vector> applied;  ///< by part of the affine stiffness
};

/// The same of a reduced response: weights of the r vectors of its basis.
using ReducedState = CompositeState<Eigen::VectorXd>;

/// State of a reduced response whose varying phases are of these materials, at a time [s] after its load was applied
/// and held: the unit load e under a traction boundary, the unit strain e' c = 1 under the others (theory, Eq. 34).
[[nodiscard]] ReducedState network_state(const ReducedResponse& response, std::span<const Material> of_phases,
                                         double time);

}  // namespace breccia::quasistatic
