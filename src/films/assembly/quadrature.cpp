#include "films/assembly/quadrature.hpp"

#include <cmath>

namespace breccia::films {

const GaussRule& gauss_rule() {
  static const GaussRule rule = {.points = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)},
                                 .weights = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}};
  return rule;
}

Eigen::Vector3d quadratic(double x) {
  return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)};
}

Eigen::Vector3d quadratic_slope(double x) {
  return {x - 0.5, -2.0 * x, x + 0.5};
}

Eigen::Vector2d linear(double x) {
  return {0.5 * (1.0 - x), 0.5 * (1.0 + x)};
}

}  // namespace breccia::films
