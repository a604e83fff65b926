#include "films/assembly/film_element.hpp"

#include <cstddef>

#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadrature.hpp"

namespace breccia::films {
namespace {

using DisplacementRow = Eigen::Matrix<double, 1, FilmElement::displacements>;

/// The linear part of the displacement in a stretch.
class LinearPart {
 public:
  explicit LinearPart(const FilmStretch& stretch) : stretch_(stretch) {
    const auto& [first, second] = stretch.ends;
    lengths_ = {(first[1] - first[0]).dot(stretch.direction), (second[1] - second[0]).dot(stretch.direction)};
    ahead_ = {(second[0] - first[0]).dot(stretch.direction), (second[1] - first[1]).dot(stretch.direction)};
  }

  [[nodiscard]] double mean_length() const { return lengths_.mean(); }
  /// Half of the length of the stretch, at a point across it from -1 to 1.
  [[nodiscard]] double half_length(double across) const { return 0.5 * linear(across).dot(lengths_); }

  /// Gradients of the functions of the nodes at a point along and across the stretch, each from -1 to 1.
  [[nodiscard]] Gradients gradients(double x, double y) const {
    const auto along = quadratic(x), slope = quadratic_slope(x);
    const auto across = linear(y);
    // The offset, along the film, of the point on the second side relative to the point on the first side.
    const double ahead = linear(x).dot(ahead_);
    Gradients gradients(2, 6);
    for (int side = 0; side < 2; ++side) {
      const double sign = side == 0 ? -0.5 : 0.5;
      for (int node = 0; node < 3; ++node) {
        const double ds = across[side] * slope[node] / half_length(y);
        const double dn = (2.0 / stretch_.thickness) * (sign * along[node] - 0.5 * ahead * ds);
        gradients.col(3 * side + node) = ds * stretch_.direction + dn * stretch_.normal;
      }
    }
    return gradients;
  }

 private:
  const FilmStretch& stretch_;
  Eigen::Vector2d lengths_;
  Eigen::Vector2d ahead_;  ///< offsets of the second side at the start and at the end, along the film
};

/// Adds the linear part with a stiffness of its strains, and the volumes and their changes by both parts.
void add_linear_part(FilmElement& element, const FilmStretch& stretch, const Eigen::Matrix3d& stiffness) {
  const LinearPart linear_part(stretch);
  const double t = stretch.thickness;
  const auto& [gauss_points, gauss_weights] = gauss_rule();
  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double x = gauss_points[i];
    const auto along = quadratic(x), slope = quadratic_slope(x);
    for (std::size_t j = 0; j < gauss_points.size(); ++j) {
      const double y = gauss_points[j];
      const double area = gauss_weights[i] * gauss_weights[j] * linear_part.half_length(y) * 0.5 * t;
      const auto strain = strain_rows(linear_part.gradients(x, y));
      element.shear.topLeftCorner<12, 12>() += area * strain.transpose() * stiffness * strain;
      element.dilatation.leftCols<12>() += area * along * (strain.row(0) + strain.row(1));
    }
    const double length = gauss_weights[i] * 0.5 * linear_part.mean_length();
    element.dilatation.rightCols<2>() -= gauss_weights[i] * t * slope * linear(x).transpose();
    element.volume += t * length * along * along.transpose();
  }
}

FilmElement empty_element() {
  FilmElement element;
  element.shear.setZero();
  element.dilatation.setZero();
  element.volume.setZero();
  return element;
}

/// The shear of a film by its strains: 2 eps_sn of the direction s along it and the normal n.
Eigen::RowVector3d shear_of_strains(const FilmStretch& stretch) {
  const auto &s = stretch.direction, &n = stretch.normal;
  return {2.0 * s.x() * n.x(), 2.0 * s.y() * n.y(), s.x() * n.y() + s.y() * n.x()};
}

}  // namespace

FilmElement film_element(const FilmStretch& stretch) {
  auto element = empty_element();
  add_linear_part(element, stretch, plane_strain_stiffness({.bulk = 0.0, .shear = 1.0}));
  const double mean_length = LinearPart(stretch).mean_length();
  const auto& [gauss_points, gauss_weights] = gauss_rule();
  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double x = gauss_points[i], length = gauss_weights[i] * 0.5 * mean_length;
    element.shear.bottomRightCorner<2, 2>() += 12.0 / stretch.thickness * length * linear(x) * linear(x).transpose();
  }
  return element;
}

FilmElement sliding_film_element(const FilmStretch& stretch) {
  auto element = empty_element();
  const Eigen::RowVector3d shear = shear_of_strains(stretch);
  add_linear_part(element, stretch, plane_strain_stiffness({.bulk = 0.0, .shear = 1.0}) - shear.transpose() * shear);
  const LinearPart linear_part(stretch);
  const auto& [gauss_points, gauss_weights] = gauss_rule();
  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double x = gauss_points[i], length = gauss_weights[i] * 0.5 * linear_part.mean_length();
    // The motion of the binder relative to the first side.
    Eigen::Matrix<double, 1, FilmElement::unknowns> motion;
    motion << 0.5 * stretch.thickness * shear * strain_rows(linear_part.gradients(x, 0.0)), linear(x).transpose();
    element.shear += 3.0 / stretch.thickness * length * motion.transpose() * motion;
  }
  return element;
}

}  // namespace breccia::films
