#pragma once

#include <Eigen/Core>

#include "discretisation/gaps/particle_images.hpp"

namespace breccia::gaps {

/// The binder between two particles along the middle of their gap, from one place to another.
struct Channel {
  /// Energy of its flow, per shear modulus of the binder: half of x' resistance x, where x is the flow at the
  /// beginning, that at the end, both along the channel, and the rotation of the second particle less that of the
  /// first.
  Eigen::Matrix3d resistance;
  double slenderness;  ///< integral of ds / h: the force of sliding per shear modulus and displacement
  double area;         ///< integral of h ds
};

/// The channel between two particles, by lubrication of the second order for a parabolic profile
/// (theory, Eq. 42g). A channel without length has none.
[[nodiscard]] Channel make_channel(const ParticleImages<2>& images, ImageIndex first, ImageIndex second,
                                   const Vector<2>& begin, const Vector<2>& end);

}  // namespace breccia::gaps
