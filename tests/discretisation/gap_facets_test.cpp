// Tests of the flow between two particles in space on a polygon in the middle of their gap (docs/gaps-in-space.md).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/gaps/space/facet.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

using Corners = std::vector<Vector<3>>;

WidthAt uniform(double width) {
  return [width](const Vector<3>&) { return GapWidth{width, {}}; };
}

/// A rectangle in a plane of constant z, counter-clockwise from its lower left corner: lower, right, upper, left edge.
Corners rectangle(const Vector<3>& corner, double width, double height) {
  const auto [x, y, z] = corner;
  return {{x, y, z}, {x + width, y, z}, {x + width, y + height, z}, {x, y + height, z}};
}

/// The flows out through the edges of a polygon in the plane z = 0 of the flow x / 2, whose divergence is 1.
Eigen::VectorXd radial_flow(const Corners& corners) {
  Eigen::VectorXd flow(static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
    flow[static_cast<Eigen::Index>(k)] = 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return flow;
}

double dissipation(const Facet& facet, const Eigen::VectorXd& flow) {
  return flow.dot(facet.resistance * flow);
}

/// Two spheres of this radius along z, with the plane z = 0 in the middle of the gap at the origin.
WidthAt between_spheres(double radius, double gap) {
  const double centre = radius + 0.5 * gap;
  return [=](const Vector<3>& point) {
    const Vector<3> from_lower = point - Vector<3>{0.0, 0.0, -centre}, from_upper = point - Vector<3>{0.0, 0.0, centre};
    const double lower = norm(from_lower), upper = norm(from_upper);
    return GapWidth{lower + upper - 2.0 * radius, from_lower / lower + from_upper / upper};
  };
}

/// The force between these spheres, per shear modulus and displacement, of the binder in a square around the axis, on
/// squares of side 1 that have the axis at a place between their corners: that of the flow, and that of the deviators
/// of the cells, whose binder is in series with rigid spheres.
double force_of_closing(double radius, double gap, int squares, const Vector<3>& axis) {
  double force = 0.0;
  for (int i = -squares; i < squares; ++i) {
    for (int j = -squares; j < squares; ++j) {
      const auto corners = rectangle(Vector<3>{static_cast<double>(i), static_cast<double>(j), 0.0} - axis, 1.0, 1.0);
      const auto facet = make_facet(corners, between_spheres(radius, gap));
      force += dissipation(facet, radial_flow(corners)) + 4.0 / 3.0 * facet.slenderness;
    }
  }
  return force;
}

TEST(GapFacet, OfUniformWidthResistsAsAChannel) {
  const double width = 0.3, length = 0.8, height = 0.5;
  const auto facet = make_facet(rectangle({0.1, 0.2, 0.7}, length, height), uniform(width));
  const Eigen::Vector4d along(0.0, 1.0, 0.0, -1.0);
  EXPECT_NEAR(dissipation(facet, along), 12.0 * length / (height * std::pow(width, 3)), 1e-9);
  EXPECT_NEAR(facet.slenderness, length * height / width, 1e-12);
  EXPECT_NEAR(facet.volume, length * height * width, 1e-12);
}

TEST(GapFacet, HasALinearFlowExactlyOnAnyPolygon) {
  const Corners corners = {{0.3, 0.1, 0.0}, {0.9, 0.2, 0.0}, {1.0, 0.7, 0.0}, {0.5, 1.0, 0.0}, {0.2, 0.6, 0.0}};
  const double width = 0.2;
  double area = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double twice = a[0] * b[1] - a[1] * b[0];
    area += 0.5 * twice;
    moment += twice / 12.0 * (dot(a, a) + dot(a, b) + dot(b, b));
  }
  const auto facet = make_facet(corners, uniform(width));
  const double expected = 12.0 / std::pow(width, 3) * 0.25 * moment + (3.6 - 4.0 / 3.0) / width * area;
  EXPECT_NEAR(dissipation(facet, radial_flow(corners)), expected, 1e-10 * expected);
}

TEST(GapFacet, DoesNotDependOnTheFirstCornerOrTheDirection) {
  Corners corners = {{0.3, 0.1, 0.0}, {0.9, 0.2, 0.1}, {1.0, 0.7, 0.0}, {0.5, 1.0, 0.2}};
  const auto width = between_spheres(5.0, 0.1);
  const Eigen::Vector4d flow(0.3, -1.0, 0.4, 0.8);
  const double expected = dissipation(make_facet(corners, width), flow);
  std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  EXPECT_NEAR(dissipation(make_facet(corners, width), Eigen::Vector4d(-1.0, 0.4, 0.8, 0.3)), expected, 1e-9 * expected);
  std::ranges::reverse(corners);
  EXPECT_NEAR(dissipation(make_facet(corners, width), Eigen::Vector4d(0.8, 0.4, -1.0, 0.3)), expected, 1e-9 * expected);
}

TEST(GapFacet, OfAWedgeHasItsVolumeAndSlenderness) {
  const double least = 0.05;
  const auto facet = make_facet(rectangle({}, 1.0, 1.0), [least](const Vector<3>& point) {
    return GapWidth{least + point[0], {1.0, 0.0, 0.0}};
  });
  EXPECT_NEAR(facet.volume, least + 0.5, 1e-9);
  EXPECT_NEAR(facet.slenderness, std::log((least + 1.0) / least), 1e-5);
}

TEST(GapFacet, OfOneTubeOfFlowBesideAThinnerOneTakesTheWiderOne) {
  // What flows from one end to the other of a wedge, across its slope, is as in channels side by side.
  const double least = 0.2;
  const auto width = [least](const Vector<3>& point) { return GapWidth{least + point[1], {0.0, 1.0, 0.0}}; };
  const auto facet = make_facet(rectangle({}, 1.0, 1.0), width);
  const Eigen::Vector4d along(0.0, 1.0, 0.0, -1.0);
  EXPECT_LT(dissipation(facet, along), 12.0 * 0.5 * (std::pow(least, -2) - std::pow(1.0 + least, -2)));
  EXPECT_GT(dissipation(facet, along), 12.0 / (0.25 * (std::pow(1.0 + least, 4) - std::pow(least, 4))));
}

TEST(GapFacet, OfClosingSpheresHasTheKnownForce) {
  // (3 pi / 2) a^2 / h + (27 pi / 20) a ln(a / h) + a constant (Jeffrey and Onishi, 1984): over half the gap, the force
  // changes by the difference of both terms.
  const double radius = 8.0;
  const auto known = [&](double gap) {
    using std::numbers::pi;
    return 1.5 * pi * radius * radius / gap + 1.35 * pi * radius * std::log(radius / gap);
  };
  for (const Vector<3>& axis : {Vector<3>{0.0, 0.0, 0.0}, Vector<3>{0.5, 0.5, 0.0}, Vector<3>{0.13, 0.31, 0.0}}) {
    const auto rest = [&](double gap) { return force_of_closing(radius, gap, 5, axis) - known(gap); };
    EXPECT_NEAR(rest(0.01) - rest(0.02), 0.0, 0.05 * 1.35 * std::numbers::pi * radius * std::numbers::ln2);
    EXPECT_NEAR(force_of_closing(radius, 0.001, 5, axis) / known(0.001), 1.0, 1e-3);
  }
}

TEST(GapFacet, WithoutAreaHasNoFlow) {
  const auto facet = make_facet(rectangle({}, 1.0, 0.0), uniform(0.1));
  EXPECT_EQ(facet.resistance, Eigen::Matrix4d::Zero());
  EXPECT_EQ(facet.slenderness, 0.0);
}

TEST(GapFacet, MayHaveAnEdgeWithoutLength) {
  const Corners corners = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
  const auto facet = make_facet(corners, uniform(0.5));
  EXPECT_TRUE(facet.resistance.allFinite());
  Eigen::VectorXd flow(5);
  flow << 0.0, 0.0, 1.0, 0.0, -1.0;
  EXPECT_NEAR(dissipation(facet, flow), 12.0 / std::pow(0.5, 3), 1e-6);
}

}  // namespace
}  // namespace breccia::gaps
