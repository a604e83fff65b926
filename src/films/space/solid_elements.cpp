#include "films/space/solid_elements.hpp"

#include <cmath>
#include <cstddef>

#include <Eigen/LU>

#include "films/assembly/quadrature.hpp"
#include "films/space/solid_strain.hpp"
#include "films/space/wedge.hpp"

namespace breccia::films {
namespace {

/// The gradients of the barycentric coordinates of a tetrahedron, and its volume.
struct Barycentric {
  Eigen::Matrix<double, 3, 4> gradients;
  double volume;
};

Barycentric barycentric(const std::array<Eigen::Vector3d, 4>& corners) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = corners[static_cast<std::size_t>(i) + 1] - corners[0];
  Barycentric found{{}, edges.determinant() / 6.0};
  found.gradients.rightCols<3>() = edges.inverse().transpose();
  found.gradients.col(0) = -found.gradients.rightCols<3>().rowwise().sum();
  return found;
}

}  // namespace

Eigen::Matrix<double, 30, 30> tetrahedron_stiffness(const std::array<Eigen::Vector3d, 4>& corners,
                                                    const Moduli& moduli) {
  constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  const auto [gradients, volume] = barycentric(corners);
  const auto elasticity = isotropic_stiffness(moduli);
  // Four points, exact to the second order (Hammer, Marlowe and Stroud 1956).
  const double near = (5.0 + 3.0 * std::sqrt(5.0)) / 20.0, far = (5.0 - std::sqrt(5.0)) / 20.0;
  Eigen::Matrix<double, 30, 30> stiffness = Eigen::Matrix<double, 30, 30>::Zero();
  for (int point = 0; point < 4; ++point) {
    Eigen::Vector4d l = Eigen::Vector4d::Constant(far);
    l[point] = near;
    SolidGradients of_nodes(3, 10);
    for (int i = 0; i < 4; ++i) of_nodes.col(i) = (4.0 * l[i] - 1.0) * gradients.col(i);
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = edges[static_cast<std::size_t>(e)];
      of_nodes.col(4 + e) = 4.0 * (l[i] * gradients.col(j) + l[j] * gradients.col(i));
    }
    const auto strain = solid_strain_rows(of_nodes);
    stiffness += volume / 4.0 * strain.transpose() * elasticity * strain;
  }
  return stiffness;
}

BinderElement channel_element(const std::array<std::array<Eigen::Vector3d, 2>, 3>& ends) {
  constexpr Eigen::Index displacements = 27, pressures = 3;
  BinderElement element{Eigen::MatrixXd::Zero(displacements, displacements),
                        Eigen::MatrixXd::Zero(pressures, displacements), Eigen::MatrixXd::Zero(pressures, pressures)};
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
    element.volume += std::abs(point.weight) * along * along.transpose();
  }
  return element;
}

BinderElement corner_element(const std::array<Eigen::Vector3d, 4>& corners) {
  const auto [gradients, volume] = barycentric(corners);
  const auto strain = solid_strain_rows(gradients);
  const auto deviatoric = isotropic_stiffness({.bulk = 0.0, .shear = 1.0});
  return {std::abs(volume) * strain.transpose() * deviatoric * strain, volume * strain.topRows<3>().colwise().sum(),
          Eigen::MatrixXd::Constant(1, 1, std::abs(volume))};
}

}  // namespace breccia::films
