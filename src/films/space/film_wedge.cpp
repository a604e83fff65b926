#include "films/space/film_wedge.hpp"

#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "films/assembly/quadrature.hpp"
#include "films/space/solid_strain.hpp"

namespace breccia::films {
namespace {

constexpr int corners_of_triangle = 3;

/// The triangle halfway between both sides, in its plane.
struct Middle {
  Eigen::Matrix<double, 3, 2> axes;
  Eigen::Matrix<double, 2, 3> gradients;  ///< gradients of the barycentric coordinates
  Eigen::Vector3d thickness;              ///< at its corners
  Eigen::Vector2d rim;                    ///< normal of the edge from the second to the third corner, with its length
  double area = 0.0;
};

Middle middle_of(const Wedge& wedge) {
  const auto& [first, second] = wedge.triangles;
  std::array<Eigen::Vector3d, 3> points;
  for (std::size_t k = 0; k < points.size(); ++k) points[k] = 0.5 * (first[k] + second[k]);
  const Eigen::Vector3d twice_area = (points[1] - points[0]).cross(points[2] - points[0]);
  const Eigen::Vector3d normal = twice_area.normalized();
  Middle middle;
  middle.area = 0.5 * twice_area.norm();
  middle.axes.col(0) = (points[1] - points[0]).normalized();
  middle.axes.col(1) = normal.cross(middle.axes.col(0));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto index = static_cast<Eigen::Index>(k);
    const Eigen::Vector2d opposite = middle.axes.transpose() * (points[(k + 2) % 3] - points[(k + 1) % 3]);
    const Eigen::Vector2d inward(-opposite.y(), opposite.x());
    middle.gradients.col(index) = inward / (2.0 * middle.area);
    middle.thickness[index] = (second[k] - first[k]).dot(normal);
    if (k == 0) middle.rim = -inward;
  }
  return middle;
}

void add_linear_part(FilmWedge& element, const Wedge& wedge) {
  const auto deviatoric = isotropic_stiffness({.bulk = 0.0, .shear = 1.0});
  for (const auto& point : integration_points(wedge)) {
    const auto in_plane = quadratic_in_triangle(point.barycentric);
    const auto slopes = quadratic_slopes(point.barycentric);
    const auto across = linear(point.along);
    SolidGradients gradients(3, 12);
    for (int side = 0; side < 2; ++side) {
      const double sign = side == 0 ? -0.5 : 0.5;
      for (int node = 0; node < 6; ++node) {
        gradients.col(6 * side + node) = across[side] * point.gradients.leftCols<3>() * slopes.col(node) +
                                         sign * in_plane[node] * point.gradients.col(3);
      }
    }
    const auto strain = solid_strain_rows(gradients);
    constexpr int count = FilmWedge::displacements;
    element.shear.topLeftCorner<count, count>() += point.weight * strain.transpose() * deviatoric * strain;
    element.dilatation.leftCols<count>() += point.weight * in_plane * strain.topRows<3>().colwise().sum();
    element.volume += point.weight * in_plane * in_plane.transpose();
  }
}

void add_flow(FilmWedge& element, const Middle& middle) {
  const auto& [places, weights] = triangle_rule();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& l = places[i];
    const double thickness = l.dot(middle.thickness), area = weights[i] * middle.area;
    const Eigen::Matrix<double, 2, 6> slopes = middle.gradients * quadratic_slopes(l);
    for (int a = 0; a < corners_of_triangle; ++a) {
      const int column = FilmWedge::displacements + 2 * a;
      for (int b = 0; b < corners_of_triangle; ++b) {
        element.shear.block<2, 2>(column, FilmWedge::displacements + 2 * b).diagonal().array() +=
            12.0 / thickness * area * l[a] * l[b];
      }
      element.dilatation.middleCols<2>(column) -= thickness * area * l[a] * slopes.transpose();
    }
  }
}

/// Adds the resistance of the bend at the rim, 12 alpha (w . m)^2 along it.
void add_rim(FilmWedge& element, const Middle& middle) {
  constexpr double alpha = 0.23;  // of a bend of 120 degrees (theory, Eq. 63a)
  const double length = middle.rim.norm();
  const Eigen::Matrix2d across = middle.rim * middle.rim.transpose() / (length * length);
  for (int a = 1; a < corners_of_triangle; ++a) {
    for (int b = 1; b < corners_of_triangle; ++b) {
      const double product = length / (a == b ? 3.0 : 6.0);
      element.shear.block<2, 2>(FilmWedge::displacements + 2 * a, FilmWedge::displacements + 2 * b) +=
          12.0 * alpha * product * across;
    }
  }
}

}  // namespace

FilmWedge film_wedge(const Wedge& wedge, bool is_at_rim) {
  FilmWedge element;
  element.shear.setZero();
  element.dilatation.setZero();
  element.volume.setZero();
  const auto middle = middle_of(wedge);
  element.axes = middle.axes;
  add_linear_part(element, wedge);
  add_flow(element, middle);
  if (is_at_rim) add_rim(element, middle);
  return element;
}

}  // namespace breccia::films
