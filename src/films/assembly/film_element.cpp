#include "films/assembly/film_element.hpp"

#include <cstddef>

#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadrature.hpp"

namespace breccia::films {

FilmElement film_element(const FilmStretch& stretch) {
  FilmElement element;
  element.shear.setZero();
  element.dilatation.setZero();
  element.volume.setZero();
  const auto& [first, second] = stretch.ends;
  const double t = stretch.thickness;
  const Eigen::Vector2d lengths{(first[1] - first[0]).dot(stretch.direction),
                                (second[1] - second[0]).dot(stretch.direction)};
  const double mean_length = lengths.mean();
  const auto& [gauss_points, gauss_weights] = gauss_rule();
  const auto deviatoric = plane_strain_stiffness({.bulk = 0.0, .shear = 1.0});

  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double x = gauss_points[i];
    const auto along = quadratic(x), slope = quadratic_slope(x);
    // The offset, along the film, of the point on the second side relative to the point on the first side.
    const double ahead = linear(x).dot(
        Eigen::Vector2d((second[0] - first[0]).dot(stretch.direction), (second[1] - first[1]).dot(stretch.direction)));
    for (std::size_t j = 0; j < gauss_points.size(); ++j) {
      const auto across = linear(gauss_points[j]);
      const double half_length = 0.5 * across.dot(lengths);
      Gradients gradients(2, 6);
      for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -0.5 : 0.5;
        for (int node = 0; node < 3; ++node) {
          const double ds = across[side] * slope[node] / half_length;
          const double dn = (2.0 / t) * (sign * along[node] - 0.5 * ahead * ds);
          gradients.col(3 * side + node) = ds * stretch.direction + dn * stretch.normal;
        }
      }
      const double area = gauss_weights[i] * gauss_weights[j] * half_length * 0.5 * t;
      const auto strain = strain_rows(gradients);
      element.shear.topLeftCorner<12, 12>() += area * strain.transpose() * deviatoric * strain;
      element.dilatation.leftCols<12>() += area * along * (strain.row(0) + strain.row(1));
    }
    const double length = gauss_weights[i] * 0.5 * mean_length;
    element.shear.bottomRightCorner<2, 2>() += 12.0 / t * length * linear(x) * linear(x).transpose();
    element.dilatation.rightCols<2>() -= gauss_weights[i] * t * slope * linear(x).transpose();
    element.volume += t * length * along * along.transpose();
  }
  return element;
}

}  // namespace breccia::films
