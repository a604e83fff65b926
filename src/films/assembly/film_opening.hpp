#pragma once

#include <Eigen/Core>

namespace breccia::films {

/// Stiffness of the opening of a film in a wall under tractions (theory, Eq. 63b).
struct FilmOpening {
  Eigen::Vector2d slip;       ///< direction of the slip, along the wall, of length 1
  Eigen::Matrix2d stiffness;  ///< stiffness of a unit shear modulus, for the flow of the film and the slip
};

/// The opening of a film along a direction of length 1, which is the positive direction of its flow; `cut` is the line
/// of the wall between its two sides.
[[nodiscard]] FilmOpening film_opening(const Eigen::Vector2d& direction, const Eigen::Vector2d& cut);

}  // namespace breccia::films
