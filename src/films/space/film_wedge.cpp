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

/// Displacements of the linear part, as strains at a point: those of six nodes on the first side, then on the second.
SolidStrainRows strain_of_displacements(const WedgePoint& point) {
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
  return solid_strain_rows(gradients);
}

/// Adds the linear part with a stiffness of its strains, and its changes of volume.
void add_linear_part(FilmWedge& element, const Wedge& wedge, const Eigen::Matrix<double, 6, 6>& stiffness) {
  for (const auto& point : integration_points(wedge)) {
    const auto in_plane = quadratic_in_triangle(point.barycentric);
    const auto strain = strain_of_displacements(point);
    constexpr int count = FilmWedge::displacements;
    element.shear.topLeftCorner<count, count>() += point.weight * strain.transpose() * stiffness * strain;
    element.dilatation.leftCols<count>() += point.weight * in_plane * strain.topRows<3>().colwise().sum();
    element.volume += point.weight * in_plane * in_plane.transpose();
    element.strain += point.weight * strain;
  }
}

/// Adds the changes of volume by the flow.
void add_flow(FilmWedge& element, const Middle& middle) {
  const auto& [places, weights] = triangle_rule();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& l = places[i];
    const double thickness = l.dot(middle.thickness), area = weights[i] * middle.area;
    const Eigen::Matrix<double, 2, 6> slopes = middle.gradients * quadratic_slopes(l);
    for (int a = 0; a < corners_of_triangle; ++a) {
      const int column = FilmWedge::displacements + 2 * a;
      element.dilatation.middleCols<2>(column) -= thickness * area * l[a] * slopes.transpose();
    }
  }
}

/// Adds the resistance of the flow in a film that adheres to both sides.
void add_resistance(FilmWedge& element, const Middle& middle) {
  const auto& [places, weights] = triangle_rule();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& l = places[i];
    const double thickness = l.dot(middle.thickness), area = weights[i] * middle.area;
    for (int a = 0; a < corners_of_triangle; ++a) {
      const int column = FilmWedge::displacements + 2 * a;
      for (int b = 0; b < corners_of_triangle; ++b) {
        element.shear.block<2, 2>(column, FilmWedge::displacements + 2 * b).diagonal().array() +=
            12.0 / thickness * area * l[a] * l[b];
      }
    }
  }
}

/// The shears of a film by its strains: 2 eps_an of both directions a in the middle of it and the normal n.
Eigen::Matrix<double, 2, 6> shears_of_strains(const Middle& middle) {
  const Eigen::Vector3d n = middle.axes.col(0).cross(middle.axes.col(1));
  Eigen::Matrix<double, 2, 6> rows;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d a = middle.axes.col(i);
    rows.row(i) << 2.0 * a.x() * n.x(), 2.0 * a.y() * n.y(), 2.0 * a.z() * n.z(), a.y() * n.z() + a.z() * n.y(),
        a.x() * n.z() + a.z() * n.x(), a.x() * n.y() + a.y() * n.x();
  }
  return rows;
}

/// Adds the resistance of the binder that moves relative to the first side alone.
void add_resistance_of_one_side(FilmWedge& element, const Wedge& wedge, const Middle& middle) {
  const auto shears = shears_of_strains(middle);
  // Of the three points across, the second is in the middle.
  const auto points = integration_points(wedge);
  const auto& [places, weights] = triangle_rule();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& l = places[i];
    const auto& point = points[3 * i + 1];
    const double thickness = l.dot(middle.thickness), area = weights[i] * middle.area;
    Eigen::Matrix<double, 2, FilmWedge::unknowns> motion;
    motion.leftCols<FilmWedge::displacements>() = 0.5 * thickness * shears * strain_of_displacements(point);
    for (int a = 0; a < corners_of_triangle; ++a) {
      motion.middleCols<2>(FilmWedge::displacements + 2 * a) = l[a] * Eigen::Matrix2d::Identity();
    }
    element.shear += 3.0 / thickness * area * motion.transpose() * motion;
  }
}

/// Adds the resistance of the bend at the rim, 12 alpha (w . m)^2 along it, times a share.
void add_rim(FilmWedge& element, const Middle& middle, double share) {
  constexpr double alpha = 0.23;  // of a bend of 120 degrees (theory, Eq. 63a)
  const double length = middle.rim.norm();
  const Eigen::Matrix2d across = middle.rim * middle.rim.transpose() / (length * length);
  for (int a = 1; a < corners_of_triangle; ++a) {
    for (int b = 1; b < corners_of_triangle; ++b) {
      const double product = length / (a == b ? 3.0 : 6.0);
      element.shear.block<2, 2>(FilmWedge::displacements + 2 * a, FilmWedge::displacements + 2 * b) +=
          share * 12.0 * alpha * product * across;
    }
  }
}

FilmWedge empty_element(const Middle& middle) {
  FilmWedge element;
  element.shear.setZero();
  element.dilatation.setZero();
  element.volume.setZero();
  element.strain.setZero();
  element.axes = middle.axes;
  return element;
}

}  // namespace

Eigen::Matrix<double, 3, 2> film_axes(const Wedge& wedge) {
  return middle_of(wedge).axes;
}

FilmWedge film_wedge(const Wedge& wedge, bool is_at_rim) {
  const auto middle = middle_of(wedge);
  auto element = empty_element(middle);
  add_linear_part(element, wedge, isotropic_stiffness({.bulk = 0.0, .shear = 1.0}));
  add_flow(element, middle);
  add_resistance(element, middle);
  if (is_at_rim) add_rim(element, middle, 1.0);
  return element;
}

Eigen::Matrix<double, FilmWedge::pressures, FilmWedge::displacements / 2> outflow_of_second_side(const Wedge& wedge) {
  const auto& [first, second] = wedge.triangles;
  Eigen::Matrix<double, FilmWedge::pressures, FilmWedge::displacements / 2> outflow;
  outflow.setZero();
  // Over the quadrilateral between the edges from the second to the third corner of both sides.
  const auto& [points, weights] = gauss_rule();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto along = linear(points[i]);
    const auto functions = quadratic_in_triangle({0.0, along[0], along[1]});
    const Eigen::Vector3d across = along[0] * (second[1] - first[1]) + along[1] * (second[2] - first[2]);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto side = linear(points[k]);
      const Eigen::Vector3d edge = side[0] * (first[2] - first[1]) + side[1] * (second[2] - second[1]);
      const double weight = 0.25 * weights[i] * weights[k] * side[1];
      const Eigen::RowVector3d outward = weight * edge.cross(across).transpose();
      for (int node = 0; node < FilmWedge::pressures; ++node) {
        outflow.middleCols<3>(3 * node) += functions * functions[node] * outward;
      }
    }
  }
  return outflow;
}

FilmWedge sliding_film_wedge(const Wedge& wedge, bool is_at_rim) {
  const auto middle = middle_of(wedge);
  auto element = empty_element(middle);
  const auto shears = shears_of_strains(middle);
  add_linear_part(element, wedge, isotropic_stiffness({.bulk = 0.0, .shear = 1.0}) - shears.transpose() * shears);
  add_flow(element, middle);
  add_resistance_of_one_side(element, wedge, middle);
  if (is_at_rim) add_rim(element, middle, 0.5);
  return element;
}

}  // namespace breccia::films
