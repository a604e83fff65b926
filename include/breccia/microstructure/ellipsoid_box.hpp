#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// A cubic box [0, side]^3 with ellipsoids. Each ellipsoid of a periodic box is listed once, with its centre in the
/// box.
struct EllipsoidBox {
  double side = 0.0;  ///< [m]
  Walls walls = Walls::hard;
  std::vector<Ellipsoid> particles = {};
  /// The number of the filler that each particle belongs to, from 0; empty where all belong to the first.
  std::vector<std::size_t> fillers = {};
  /// Thickness of the coating around each particle [m]; the coating is the set of points within this distance of it.
  /// Empty where no particle has one.
  std::vector<double> coatings = {};

  [[nodiscard]] std::size_t filler_of(std::size_t particle) const { return fillers.empty() ? 0 : fillers.at(particle); }
  [[nodiscard]] double coating_of(std::size_t particle) const { return coatings.empty() ? 0.0 : coatings.at(particle); }
};

/// The box with its particles as balls, if all of them are balls; nothing otherwise.
[[nodiscard]] std::optional<Microstructure<3>> as_balls(const EllipsoidBox& box);

/// Volume of the particles per volume of the box, without coatings.
[[nodiscard]] double volume_fraction(const EllipsoidBox& box);
/// Volume of the coatings per volume of the box.
[[nodiscard]] double coating_fraction(const EllipsoidBox& box);
/// Surface of the particles per volume of the box [1/m].
[[nodiscard]] double specific_surface(const EllipsoidBox& box);
/// Smallest distance between two particles with their coatings [m], across the sides too if the box is periodic (where
/// a particle also faces its own image). Negative if two overlap, infinite if there are no two.
[[nodiscard]] double smallest_gap(const EllipsoidBox& box);
/// Smallest distance between a particle with its coating and a hard wall [m]. Negative if one crosses a wall, infinite
/// if there are no particles or no walls.
[[nodiscard]] double smallest_wall_gap(const EllipsoidBox& box);
/// Smallest distance between a particle without its coating and a side of the box [m]; negative where one crosses it.
[[nodiscard]] double smallest_side_distance(const EllipsoidBox& box);

/// Throws InputError if the particles are invalid: an axis that is not positive, directions of axes that are not
/// perpendicular and of length 1, a centre outside the box, a particle or its coating across a hard wall, two particles
/// that overlap by more than roundoff. The message lists up to twenty mistakes, counting particles from 1.
void require_valid(const EllipsoidBox& box);

}  // namespace breccia
