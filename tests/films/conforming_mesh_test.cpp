#include "films/mesh/conforming_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/grains_and_films.hpp"
#include "messages.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::films {
namespace {

using testing::HasSubstr;

FilmProblem<2> grains_in_the_plane(Boundary boundary) {
  auto problem = test::voronoi_problem(boundary);
  problem.layers = 2;
  return problem;
}

FilmProblem<3> grains_in_space() {
  RandomTessellationRequest request;
  request.side = 1e-3;
  for (int i = 0; i < 10; ++i) request.diameters.push_back(1.0 + 0.1 * i);
  const Tessellation<3> tessellation(random_sites<3>(request));
  return {.tessellation = tessellation,
          .thickness = film_thickness(tessellation, 0.9),
          .grain = test::hmx,
          .elements = {.divisions = 2},
          .layers = 2};
}

/// The share of the box that the elements of the grains, or of the binder, fill.
template <int dim>
double share_of(const ConformingMesh<dim>& mesh, bool is_grain) {
  double sum = 0.0;
  for (const auto& element : mesh.elements) {
    if (element.grain.has_value() == is_grain) sum += content_of(mesh, element);
  }
  return sum / std::pow(mesh.side, dim);
}

template <int dim>
std::size_t inverted(const ConformingMesh<dim>& mesh) {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh.elements, [&](const Simplex<dim>& element) { return !(content_of(mesh, element) > 0.0); }));
}

/// Sets of the nodes of facets.
template <int dim>
std::set<std::set<std::size_t>> facets_of(const MeshSurface<dim>& surface) {
  std::set<std::set<std::size_t>> facets;
  for (const auto& facet : surface.facets) facets.insert({facet.begin(), facet.end()});
  return facets;
}

/// Expects that each surface beyond which an image lies has an opposite one, which is that surface displaced.
template <int dim>
void expect_periodic(const ConformingMesh<dim>& mesh) {
  EXPECT_EQ(mesh.surfaces.size(), 2 * mesh.opposites.size());
  for (const auto& [first, second, displacement, nodes] : mesh.opposites) {
    std::map<std::size_t, std::size_t> displaced;
    for (const auto& [node, other] : nodes) {
      displaced[node] = other;
      for (std::size_t axis = 0; axis < displacement.size(); ++axis) {
        EXPECT_NEAR(mesh.nodes[other][axis] - mesh.nodes[node][axis], mesh.side * displacement[axis],
                    1e-14 * mesh.side);
      }
    }
    EXPECT_EQ(mesh.surfaces[second].direction, displacement);
    std::set<std::set<std::size_t>> images;
    for (const auto& facet : mesh.surfaces[first].facets) {
      std::set<std::size_t> image;
      for (const auto node : facet) image.insert(displaced.at(node));
      images.insert(image);
    }
    EXPECT_EQ(images, facets_of(mesh.surfaces[second]));
  }
}

/// Expects that every facet belongs to two elements, or to one and the surface.
template <int dim>
void expect_conforming(const ConformingMesh<dim>& mesh) {
  std::map<std::set<std::size_t>, int> elements_at;
  for (const auto& element : mesh.elements) {
    for (const auto without : element.nodes) {
      std::set<std::size_t> facet(element.nodes.begin(), element.nodes.end());
      facet.erase(without);
      ++elements_at[facet];
    }
  }
  std::size_t on_surface = 0;
  for (const auto& surface : mesh.surfaces) {
    for (const auto& facet : facets_of(surface)) {
      ++elements_at.at(facet);
      ++on_surface;
    }
  }
  EXPECT_GT(on_surface, 0U);
  EXPECT_TRUE(std::ranges::all_of(elements_at, [](const auto& facet) { return facet.second == 2; }));
}

// By Gauss' theorem the surface that the facets make up encloses the mesh, if all of them are seen from outside.
double enclosed_area(const ConformingMesh<2>& mesh) {
  double sum = 0.0;
  for (const auto& surface : mesh.surfaces) {
    for (const auto& [begin, end] : surface.facets) sum += 0.5 * cross(mesh.nodes[begin], mesh.nodes[end]);
  }
  return sum;
}

double enclosed_volume(const ConformingMesh<3>& mesh) {
  double sum = 0.0;
  for (const auto& surface : mesh.surfaces) {
    for (const auto& [a, b, c] : surface.facets) {
      const auto &u = mesh.nodes[a], &v = mesh.nodes[b], &w = mesh.nodes[c];
      sum += dot(u, Vector<3>{v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]}) / 6.0;
    }
  }
  return sum;
}

TEST(ConformingMesh, OfGrainsInThePlaneTilesIt) {
  const auto problem = grains_in_the_plane(Boundary::periodic);
  const auto mesh = conforming_mesh(problem);
  EXPECT_EQ(inverted(mesh), 0U);
  EXPECT_NEAR(share_of(mesh, true), grain_fraction(problem.tessellation, problem.thickness), 1e-12);
  EXPECT_NEAR(share_of(mesh, true) + share_of(mesh, false), 1.0, 1e-12);
  EXPECT_NEAR(enclosed_area(mesh), 1.0, 1e-12);
  expect_periodic(mesh);
  expect_conforming(mesh);
}

TEST(ConformingMesh, OfCutGrainsEndsAtTheWalls) {
  const auto mesh = conforming_mesh(grains_in_the_plane(Boundary::displacement));
  EXPECT_EQ(inverted(mesh), 0U);
  EXPECT_NEAR(share_of(mesh, true) + share_of(mesh, false), 1.0, 1e-12);
  expect_conforming(mesh);
  EXPECT_TRUE(mesh.opposites.empty());
  ASSERT_EQ(mesh.surfaces.size(), 4U);
  for (const auto& surface : mesh.surfaces) {
    EXPECT_EQ(surface.beyond, Beyond::wall);
    double length = 0.0;
    for (const auto& [begin, end] : surface.facets) length += norm(mesh.nodes[end] - mesh.nodes[begin]);
    EXPECT_NEAR(length, 1.0, 1e-12);
  }
}

TEST(ConformingMesh, OfGrainsInSpaceFillsIt) {
  const auto problem = grains_in_space();
  const auto mesh = conforming_mesh(problem);
  EXPECT_EQ(inverted(mesh), 0U);
  EXPECT_NEAR(share_of(mesh, true), 0.9, 1e-9);
  EXPECT_NEAR(share_of(mesh, true) + share_of(mesh, false), 1.0, 1e-9);
  EXPECT_NEAR(enclosed_volume(mesh) / std::pow(mesh.side, 3), 1.0, 1e-9);
  expect_periodic(mesh);
  expect_conforming(mesh);
  std::set<std::size_t> grains;
  for (const auto& element : mesh.elements) {
    if (element.grain) grains.insert(*element.grain);
  }
  EXPECT_EQ(grains.size(), 10U);
}

TEST(ConformingMesh, HasGapsInPlaceOfDebondedFilms) {
  auto problem = grains_in_the_plane(Boundary::periodic);
  const auto bonded = conforming_mesh(problem);
  problem.debonded.faces = random_faces(problem.tessellation, 0.2, 1).faces;
  const auto mesh = conforming_mesh(problem);
  EXPECT_NEAR(share_of(mesh, true), share_of(bonded, true), 1e-12);
  EXPECT_LT(share_of(mesh, false), 0.9 * share_of(bonded, false));
  expect_conforming(mesh);
  const auto gap = std::ranges::find(mesh.surfaces, Beyond::gap, &MeshSurface<2>::beyond);
  ASSERT_NE(gap, mesh.surfaces.end());
  EXPECT_NEAR(enclosed_area(mesh), share_of(mesh, true) + share_of(mesh, false), 1e-12);
}

TEST(ConformingMesh, TakesANumberOfLayers) {
  EXPECT_THAT(test::message_of<InputError>([] { static_cast<void>(conforming_mesh(test::voronoi_problem())); }),
              HasSubstr("takes a number of layers"));
}

}  // namespace
}  // namespace breccia::films
