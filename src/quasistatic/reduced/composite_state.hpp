#pragma once

#include <vector>

#include <Eigen/Core>

namespace breccia::quasistatic {

/// A composite at one time: its displacement, and the moduli that vary applied to the history of the displacement, the
/// Stieltjes integrals of M(t - t') du(t') [Pa] (theory, Eq. 35).
template <class Vector>
struct CompositeState {
  Vector displacement;
  std::vector<Vector> applied;  ///< products by part of the affine stiffness
};

/// The state of a reduced response: weights of the r vectors of its basis.
using ReducedState = CompositeState<Eigen::VectorXd>;

}  // namespace breccia::quasistatic
