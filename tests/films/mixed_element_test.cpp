#include "films/assembly/mixed_element.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace breccia::films {
namespace {

/// The nodes of an element: corners, the middles of the edges and, for a quadrilateral, the centre.
template <std::size_t count>
std::vector<Eigen::Vector2d> nodes_of(const std::array<Eigen::Vector2d, count>& corners) {
  std::vector<Eigen::Vector2d> nodes(corners.begin(), corners.end());
  for (std::size_t c = 0; c < count; ++c) nodes.emplace_back(0.5 * (corners[c] + corners[(c + 1) % count]));
  if (count == 4) nodes.emplace_back(0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
  return nodes;
}

template <class At>
Eigen::VectorXd displacements(const std::vector<Eigen::Vector2d>& nodes, const At& at) {
  Eigen::VectorXd u(2 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) u.segment<2>(2 * static_cast<Eigen::Index>(n)) = at(nodes[n]);
  return u;
}

void expect_exact_for_uniform_strain(const MixedElement& element, const std::vector<Eigen::Vector2d>& nodes,
                                     double area) {
  const auto u = displacements(nodes, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return Eigen::Matrix2d{{1.0, 0.5}, {0.7, 3.0}} * x;
  });
  // Twice the energy is 2 (eps : eps - tr^2 / 3) times the area.
  EXPECT_NEAR(u.dot(element.shear * u), 2.0 * (1.0 + 9.0 + 2.0 * 0.36 - 16.0 / 3.0) * area, 1e-13);
  EXPECT_NEAR((element.dilatation * u).sum(), 4.0 * area, 1e-14);
  EXPECT_NEAR(element.volume.sum(), area, 1e-15);
}

TEST(MixedElement, IsExactForUniformStrains) {
  const std::array triangle = {Eigen::Vector2d(0.1, 0.0), Eigen::Vector2d(1.1, 0.2), Eigen::Vector2d(0.3, 0.8)};
  expect_exact_for_uniform_strain(mixed_triangle(triangle), nodes_of(triangle), 0.5 * (0.8 - 0.2 * 0.2));
  const std::array trapezium = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(1.5, 0.5),
                                Eigen::Vector2d(0.3, 0.5)};
  expect_exact_for_uniform_strain(mixed_quadrilateral(trapezium), nodes_of(trapezium), 0.5 * 0.5 * (2.0 + 1.2));
}

// The parabola 6 w n (t - n) / t^2 of a flow along a rectangle has the mean w and the energy 6 w^2 / t a length.
TEST(MixedElement, HasTheParabolaOfAFlow) {
  constexpr double length = 3.0, thickness = 0.1, flow = 0.4;
  const std::array rectangle = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(length, 0.0),
                                Eigen::Vector2d(length, thickness), Eigen::Vector2d(0.0, thickness)};
  const auto element = mixed_quadrilateral(rectangle);
  const auto u = displacements(nodes_of(rectangle), [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return {6.0 * flow * x.y() * (thickness - x.y()) / (thickness * thickness), 0.0};
  });
  EXPECT_NEAR(u.dot(element.shear * u) / (12.0 * flow * flow / thickness * length), 1.0, 1e-12);
  EXPECT_LT((element.dilatation * u).cwiseAbs().maxCoeff(), 1e-14);
}

// The test integrates the change of area by the displacement x^2 / 2, weighted by the pressure x, which grows along the
// element.
TEST(MixedElement, WeighsTheChangeOfVolume) {
  const std::array square = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1.0, 1.0),
                             Eigen::Vector2d(0.0, 1.0)};
  const auto element = mixed_quadrilateral(square);
  const auto u = displacements(nodes_of(square), [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return {0.5 * x.x() * x.x(), 0.0};
  });
  const Eigen::Vector4d pressure(0.0, 1.0, 1.0, 0.0);
  EXPECT_NEAR(pressure.dot(element.dilatation * u), 1.0 / 3.0, 1e-14);
}

}  // namespace
}  // namespace breccia::films
