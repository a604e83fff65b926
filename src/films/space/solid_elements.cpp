#include "films/space/solid_elements.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "films/assembly/quadrature.hpp"
#include "films/space/solid_strain.hpp"
#include "films/space/wedge.hpp"

namespace breccia::films {
namespace {

/// The gradients of the barycentric coordinates of a tetrahedron times six times its volume.
Eigen::Matrix<double, 3, 4> scaled_gradients(const TetrahedronCorners& corners) {
  const Eigen::Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  Eigen::Matrix<double, 3, 4> gradients;
  gradients.rightCols<3>() << b.cross(c), c.cross(a), a.cross(b);
  gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
  return gradients;
}

/// A point of integration in a tetrahedron: its barycentric coordinates and the gradients of the quadratic functions.
struct TetrahedronPoint {
  Eigen::Vector4d barycentric;
  SolidGradients gradients;
};

/// Four points of equal weights, exact to the second order (Hammer, Marlowe and Stroud 1956).
std::array<TetrahedronPoint, 4> integration_points(const TetrahedronCorners& corners) {
  const Eigen::Matrix<double, 3, 4> linear_gradients = scaled_gradients(corners) / (6.0 * volume_of(corners));
  const double near = (5.0 + 3.0 * std::sqrt(5.0)) / 20.0, far = (5.0 - std::sqrt(5.0)) / 20.0;
  std::array<TetrahedronPoint, 4> points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto& [l, gradients] = points[p];
    l.setConstant(far);
    l[static_cast<Eigen::Index>(p)] = near;
    gradients.resize(3, 10);
    for (int i = 0; i < 4; ++i) gradients.col(i) = (4.0 * l[i] - 1.0) * linear_gradients.col(i);
    for (std::size_t e = 0; e < edges_of_tetrahedron.size(); ++e) {
      const auto i = static_cast<Eigen::Index>(edges_of_tetrahedron[e][0]);
      const auto j = static_cast<Eigen::Index>(edges_of_tetrahedron[e][1]);
      gradients.col(4 + static_cast<Eigen::Index>(e)) =
          4.0 * (l[i] * linear_gradients.col(j) + l[j] * linear_gradients.col(i));
    }
  }
  return points;
}

}  // namespace

double volume_of(const TetrahedronCorners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) / 6.0;
}

Eigen::Matrix<double, 30, 30> tetrahedron_stiffness(const TetrahedronCorners& corners,
                                                    const Eigen::Matrix<double, 6, 6>& elasticity) {
  Eigen::Matrix<double, 30, 30> stiffness = Eigen::Matrix<double, 30, 30>::Zero();
  for (const auto& point : integration_points(corners)) {
    const auto strain = solid_strain_rows(point.gradients);
    stiffness += volume_of(corners) / 4.0 * strain.transpose() * elasticity * strain;
  }
  return stiffness;
}

Eigen::Matrix<double, 6, 30> tetrahedron_strain(const TetrahedronCorners& corners) {
  Eigen::Matrix<double, 6, 30> strain = Eigen::Matrix<double, 6, 30>::Zero();
  for (const auto& point : integration_points(corners)) {
    strain += volume_of(corners) / 4.0 * solid_strain_rows(point.gradients);
  }
  return strain;
}

BinderElement taylor_hood_element(const TetrahedronCorners& corners) {
  const double volume = volume_of(corners);
  BinderElement element{tetrahedron_stiffness(corners, isotropic_stiffness({.bulk = 0.0, .shear = 1.0})),
                        Eigen::MatrixXd::Zero(4, 30), Eigen::MatrixXd::Constant(4, 4, volume / 20.0),
                        tetrahedron_strain(corners)};
  element.volume.diagonal().array() += volume / 20.0;
  for (const auto& [barycentric, gradients] : integration_points(corners)) {
    const auto strain = solid_strain_rows(gradients);
    element.dilatation += volume / 4.0 * barycentric * strain.topRows<3>().colwise().sum();
  }
  return element;
}

BinderElement channel_element(const std::array<std::array<Eigen::Vector3d, 2>, 3>& ends) {
  constexpr Eigen::Index displacements = 27, pressures = 3;
  BinderElement element{Eigen::MatrixXd::Zero(displacements, displacements),
                        Eigen::MatrixXd::Zero(pressures, displacements), Eigen::MatrixXd::Zero(pressures, pressures),
                        Eigen::MatrixXd::Zero(6, displacements)};
  const auto deviatoric = isotropic_stiffness({.bulk = 0.0, .shear = 1.0});
  for (const auto& point :
       integration_points({{{{ends[0][0], ends[1][0], ends[2][0]}, {ends[0][1], ends[1][1], ends[2][1]}}}})) {
    const auto along = quadratic(point.along), slope = quadratic_slope(point.along);
    SolidGradients gradients(3, 9);
    for (int grain = 0; grain < 3; ++grain) {
      for (int node = 0; node < 3; ++node) {
        gradients.col(3 * grain + node) =
            along[node] * point.gradients.col(grain) + point.barycentric[grain] * slope[node] * point.gradients.col(3);
      }
    }
    const auto strain = solid_strain_rows(gradients);
    element.shear += std::abs(point.weight) * strain.transpose() * deviatoric * strain;
    element.dilatation += point.weight * along * strain.topRows<3>().colwise().sum();
    element.strain += point.weight * strain;
    element.volume += std::abs(point.weight) * along * along.transpose();
  }
  return element;
}

BinderElement corner_element(const TetrahedronCorners& corners) {
  const auto strain = solid_strain_rows(scaled_gradients(corners));
  const auto deviatoric = isotropic_stiffness({.bulk = 0.0, .shear = 1.0});
  const double volume = volume_of(corners);
  double size = 0.0;
  for (const auto& corner : corners) size = std::max(size, (corner - corners[0]).norm());
  // Between grains that are all but vanished four corners may be almost in a plane, or the tetrahedron inverted.
  constexpr double least_share = 1e-6;
  const double positive = std::max(std::abs(volume), least_share * size * size * size);
  return {strain.transpose() * deviatoric * strain / (36.0 * positive), strain.topRows<3>().colwise().sum() / 6.0,
          Eigen::MatrixXd::Constant(1, 1, std::abs(volume)), strain / 6.0};
}

}  // namespace breccia::films
