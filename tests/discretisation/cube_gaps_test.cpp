// Tests of the gaps of spheres under a cubic cell (docs/gaps-in-space.md).

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/gaps/linear_motion.hpp"
#include "discretisation/gaps/space/cube_cells.hpp"
#include "discretisation/gaps/space/cube_terms.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr int cubes_along = 12;

/// A cubic array of equal spheres with these places in its cell, in a periodic box of `cubes_along` cells.
Microstructure<3> array_of(const std::vector<Vector<3>>& places, double distance, double gap) {
  Microstructure<3> box = {static_cast<double>(cubes_along), Walls::periodic, {}};
  const Vector<3> origin = {0.3, 0.1, 0.2};
  for (const auto& place : places) {
    box.particles.push_back({cubes_along * place + origin, cubes_along * distance / (1.0 + gap)});
  }
  return box;
}

Microstructure<3> simple_cubic(double gap) {
  return array_of({{0.0, 0.0, 0.0}}, 1.0, gap);
}
Microstructure<3> body_centred(double gap) {
  return array_of({{0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}}, std::sqrt(0.75), gap);
}
Microstructure<3> face_centred(double gap) {
  return array_of({{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}}, std::sqrt(0.5), gap);
}

ParticlesInBox<3> uncoated(const Microstructure<3>& box) {
  return {box, 0, std::vector<ParticlePhases>(box.particles.size(), {.phase = 1})};
}

struct CubeGeometry {
  explicit CubeGeometry(const Microstructure<3>& box)
      : images(uncoated(box), cubes_along, Boundary::periodic),
        owners(images),
        faces(images, owners),
        phases(box.particles.size(), {.phase = 1}) {}

  [[nodiscard]] GapGeometry<3> all() const { return {images, owners, faces, 0, phases}; }

  ParticleImages<3> images;
  Owners<3> owners;
  CubeFaces faces;
  std::vector<ParticlePhases> phases;
};

/// Calls action(cell) for all cells of the box.
template <class Action>
void for_each_cube(const Action& action) {
  for_each_index(Index<3>{}, Index<3>{cubes_along, cubes_along, cubes_along}, action);
}

using Array = Microstructure<3> (*)(double gap);
class CubicArrays : public testing::TestWithParam<Array> {};

// A flux follows a particle up to its surface, so that it is exact for a linear displacement.
TEST_P(CubicArrays, ALinearDisplacementWithoutDilatationChangesNoVolume) {
  Eigen::Matrix3d gradient;
  gradient << 0.3, 0.7, -0.4, -0.2, -0.5, 0.6, 0.1, 0.8, 0.2;
  const auto motion = linear_motion<3>(gradient);
  for (const double gap : {0.01, 0.1}) {
    const CubeGeometry geometry(GetParam()(gap));
    for_each_cube([&](const Index<3>& cell) {
      const CubePlace place(geometry.all(), cell);
      ASSERT_NEAR(volume_change(place).dot(motion), 0.0, 1e-13) << cell[0] << ' ' << cell[1] << ' ' << cell[2];
    });
  }
}

// Neighbouring cells see the same volume pass through their face.
TEST_P(CubicArrays, WhatLeavesACellEntersItsNeighbour) {
  const auto found = find_gap_cells(uncoated(GetParam()(0.02)), cubes_along, Boundary::periodic);
  std::vector<double> total(static_cast<std::size_t>(found.unknowns()), 0.0);
  std::vector<int> seen(total.size(), 0);
  for (const auto& cell : found.cells()) {
    for (std::size_t k = 0; k < cell.gap_unknowns.size(); ++k) {
      const auto number = cell.gap_unknowns[k];
      if (number == GapCell<3>::none) continue;
      total[static_cast<std::size_t>(number)] += cell.volume[CellShape<3>::dofs + static_cast<Eigen::Index>(k)];
      ++seen[static_cast<std::size_t>(number)];
    }
  }
  ASSERT_FALSE(total.empty());
  for (std::size_t i = 0; i < total.size(); ++i) {
    EXPECT_NEAR(total[i], 0.0, 1e-13);
    EXPECT_TRUE(seen[i] == 2 || seen[i] == 8) << seen[i];  // the cells at a face, or at a node
  }
}

// The slopes have the rotation of the particle. Those of nodes without a neighbour of their particle along the slope or
// along the component are tied to zero.
TEST_P(CubicArrays, ParticlesThatTurnTogetherHaveNoEnergy) {
  const CubeGeometry geometry(GetParam()(0.02));
  Eigen::Matrix3d rotation;
  rotation << 0.0, 0.7, -0.4, -0.7, 0.0, 0.6, 0.4, -0.6, 0.0;
  const auto motion = linear_motion<3>(rotation);
  const auto has_own_neighbour = [&](const Index<3>& node, std::size_t axis) {
    auto before = node, behind = node;
    --before[axis];
    ++behind[axis];
    const auto owner = geometry.owners.of(node);
    return geometry.owners.of(before) == owner || geometry.owners.of(behind) == owner;
  };
  int tied = 0;
  for_each_cube([&](const Index<3>& cell) {
    const CubePlace place(geometry.all(), cell);
    ASSERT_NEAR(volume_change(place).dot(motion), 0.0, 1e-12);
    int without_neighbour = 0, with_energy = 0;
    for (int node = 0; node < CellShape<3>::nodes; ++node) {
      for (const auto& slope : slopes_of_node) {
        if (geometry.faces.slope(place.node(node), slope) == GapCell<3>::none) continue;
        ++tied;
        const bool has_neighbour =
            has_own_neighbour(place.node(node), slope.along) || has_own_neighbour(place.node(node), slope.component);
        if (!has_neighbour) ++without_neighbour;
      }
    }
    std::vector<SquareTerm<3>> terms;
    tie_slopes(geometry.all(), place, terms);
    for (const auto& term : terms) with_energy += std::abs(term.form.of(motion)) > 1e-12 ? 1 : 0;
    ASSERT_EQ(with_energy, without_neighbour);
  });
  EXPECT_GT(tied, 1000);
}

INSTANTIATE_TEST_SUITE_P(All, CubicArrays, testing::Values(simple_cubic, body_centred, face_centred),
                         [](const auto& info) {
                           return info.index == 0 ? "Simple" : info.index == 1 ? "BodyCentred" : "FaceCentred";
                         });

TEST(SphereOutline, HasTheDistancesTheChordsAndTheVolumeOfItsSphere) {
  const SphereOutline outline({{1.0, 2.0, 3.0}, 1.0}, 0.25, 2.0);  // around (2, 4, 6), with a radius of 1.5
  EXPECT_NEAR(outline.distance({2.0, 4.0, 9.0}), 1.5, 1e-14);
  EXPECT_NEAR(outline.distance({2.5, 4.0, 6.0}), -1.0, 1e-14);
  EXPECT_EQ(outline.normal({2.0, 1.0, 6.0}), (Vector<3>{0.0, -1.0, 0.0}));
  const auto chord = outline.chord({{2.9, 4.0, 5.0}, 2});
  ASSERT_TRUE(chord.has_value());
  EXPECT_NEAR(chord->begin, 1.0 - 1.2, 1e-14);
  EXPECT_NEAR(chord->end, 1.0 + 1.2, 1e-14);
  EXPECT_FALSE(outline.chord({{3.6, 4.0, 5.0}, 2}).has_value());
  double volume = 0.0;
  for_each_index(Index<3>{0, 2, 4}, Index<3>{4, 6, 8}, [&](const Index<3>& cell) {
    volume += outline.content_of_cell({1.0 * cell[0], 1.0 * cell[1], 1.0 * cell[2]});
  });
  EXPECT_NEAR(volume, 4.0 / 3.0 * std::numbers::pi * 1.5 * 1.5 * 1.5, 1e-12);
}

// Their cells are those of a box without gaps, those between core and coating included.
TEST(CubeCells, OfCoatedSpheresFarFromOneAnotherHaveNoGaps) {
  const ParticlesInBox<3> coated = {
      {1.0, Walls::periodic, {{{0.5, 0.5, 0.5}, 0.4}}}, 0, {{.phase = 1, .coating = 2, .coating_thickness = 0.05}}};
  EXPECT_EQ(find_gap_cells(coated, 16, Boundary::periodic).unknowns(), 0);
  EXPECT_TRUE(find_gap_cells(coated, 16, Boundary::periodic).cells().empty());
  EXPECT_GT(find_gap_cells(coated, 6, Boundary::periodic).unknowns(), 0);
}

TEST(CubeCells, OfInvalidSpheresAreRefused) {
  const Microstructure<3> box = {1.0, Walls::periodic, {{{0.5, 0.5, 0.5}, 0.9}}};
  const auto refuse = [&](std::vector<ParticlePhases> phases, Boundary boundary = Boundary::periodic) {
    EXPECT_THROW((void)find_gap_cells({box, 0, std::move(phases)}, 8, boundary), InputError);
  };
  refuse({});
  refuse({{.phase = 1, .coating = 2, .coating_thickness = -0.1}});
  refuse({{.phase = 1, .coating = 2, .coating_thickness = 0.1}});  // overlaps its image
  refuse({{.phase = 1}}, Boundary::traction);
}

}  // namespace
}  // namespace breccia::gaps
