#include "films/assembly/film_opening.hpp"

#include <algorithm>
#include <cmath>

namespace breccia::films {

// The polynomials were fitted by tests/reference/film_opening.py to a layer that is cut under angles from 30 to 90
// degrees; their error is less than 0.001. For smaller angles the values at 30 degrees are taken.
FilmOpening film_opening(const Eigen::Vector2d& direction, const Eigen::Vector2d& cut) {
  constexpr double of_30_degrees = 0.75;  // the square of the cosine
  Eigen::Vector2d slip = cut.normalized();
  if (slip.dot(direction) < 0.0) slip = -slip;
  const double x = std::min(std::pow(slip.dot(direction), 2), of_30_degrees);
  const double cosine = std::sqrt(x), sine = std::sqrt(1.0 - x);
  const double compliance = 0.1149 + x * (0.0632 + x * (-0.0382 + x * 0.1368));
  const double carried = cosine * (-0.3344 + x * (-0.1742 + x * (0.1461 - x * 0.3101)));
  const Eigen::Vector2d apart(-carried, 1.0);  // the slip minus the part by which the flow carries it along
  return {slip, 1.0 / (compliance * sine) * apart * apart.transpose()};
}

}  // namespace breccia::films
