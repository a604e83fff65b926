#include "films/mesh/grain_mesh.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "films/assembly/plane_strain.hpp"
#include "films/assembly/quadratic_triangle.hpp"
#include "films/grains_and_films.hpp"
#include "films/mesh/film_network.hpp"

namespace breccia::films {
namespace {

double area_of_triangles(const GrainMesh& mesh) {
  double sum = 0.0;
  for (const auto& nodes : mesh.triangles) {
    const double of_one = area({mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]]});
    EXPECT_GT(of_one, 0.0);
    sum += of_one;
  }
  return sum;
}

GrainPolygon regular_polygon(int corners) {
  GrainPolygon grain;
  for (int c = 0; c < corners; ++c) {
    const double angle = 2.0 * std::numbers::pi * c / corners;
    grain.corners.emplace_back(2.0 + std::cos(angle), 1.0 + std::sin(angle));
  }
  return grain;
}

TEST(GrainMesh, FillsTheGrain) {
  for (const double face_share : {0.6, 0.3, 0.04}) {
    const auto network = film_network(test::voronoi_problem().tessellation, test::film_of_25, face_share);
    for (std::size_t g = 0; g < network.grains.size(); ++g) {
      const auto mesh = grain_mesh(network.grains[g], network.segments[g]);
      EXPECT_NEAR(area_of_triangles(mesh), area(network.grains[g].corners), 1e-14);
    }
  }
}

TEST(GrainMesh, HasTheNodesOfTheFacesInTheirOrder) {
  const auto grain = regular_polygon(5);
  const auto mesh = grain_mesh(grain, std::vector{1, 2, 3, 1, 1});
  EXPECT_EQ(mesh.boundary_nodes, 16U);
  EXPECT_EQ(mesh.nodes[2], grain.corners[1]);
  EXPECT_EQ(mesh.nodes[6], grain.corners[2]);
  EXPECT_LT((mesh.nodes[1] - 0.5 * (grain.corners[0] + grain.corners[1])).norm(), 1e-15);
}

/// Twice the energy of the triangles of a grain, for displacements of its nodes by their positions.
template <class At>
double energy(const GrainMesh& mesh, const Moduli& moduli, const At& at) {
  const auto elasticity = plane_strain_stiffness(moduli);
  double sum = 0.0;
  for (const auto& nodes : mesh.triangles) {
    Eigen::Matrix<double, 12, 1> u;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      u.segment<2>(2 * static_cast<Eigen::Index>(n)) = at(mesh.nodes[nodes[n]]);
    const auto triangle = quadratic_triangle({mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]]});
    sum += u.dot(triangle_stiffness(triangle, elasticity) * u);
  }
  return sum;
}

TEST(GrainTriangles, AreExactForUniformStrains) {
  const auto grain = regular_polygon(6);
  const auto mesh = grain_mesh(grain, std::vector(6, 3));
  const auto of_gradient = [&](double h11, double h12, double h21, double h22) {
    const Eigen::Matrix2d gradient{{h11, h12}, {h21, h22}};
    const auto at = [&](const Eigen::Vector2d& x) -> Eigen::Vector2d { return gradient * x; };
    return energy(mesh, {.bulk = 5.0, .shear = 2.0}, at) / area(grain.corners);
  };
  EXPECT_NEAR(of_gradient(0.0, 1.0, -1.0, 0.0), 0.0, 1e-12);                     // a rotation
  EXPECT_NEAR(of_gradient(0.0, 1.0, 0.0, 0.0), 2.0, 1e-12);                      // G
  EXPECT_NEAR(of_gradient(1.0, 0.0, 0.0, -1.0), 4.0 * 2.0, 1e-12);               // 4 G
  EXPECT_NEAR(of_gradient(1.0, 0.0, 0.0, 1.0), 4.0 * (5.0 + 2.0 / 3.0), 1e-11);  // 4 (K + G / 3)
}

// Quadratic displacements are exact: bending, u = (x y, -x^2 / 2 + c y^2 / 2) with free sides.
TEST(GrainTriangles, AreExactForBending) {
  constexpr double bulk = 5.0, shear = 2.0, a = bulk + 4.0 / 3.0 * shear, b = bulk - 2.0 / 3.0 * shear;
  GrainPolygon square;
  square.corners = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  const auto mesh = grain_mesh(square, std::vector(4, 3));
  const auto bending = [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return {x.x() * x.y(), -0.5 * x.x() * x.x() - 0.5 * b / a * x.y() * x.y()};
  };
  // Twice the energy: the axial stress (a - b^2 / a) y times the strain y, over the square.
  EXPECT_NEAR(energy(mesh, {.bulk = bulk, .shear = shear}, bending), (a - b * b / a) * 4.0 / 3.0, 1e-11);
}

}  // namespace
}  // namespace breccia::films
