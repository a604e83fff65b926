// Tests of the geometry of gaps under a cell and of the energies that follow from it (theory, section 2).

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/gaps/plane/cell_shares.hpp"
#include "discretisation/gaps/plane/cell_terms.hpp"
#include "discretisation/gaps/plane/square_cells.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr int cells = 20;

/// Equal discs on a square lattice in a periodic box of `cells` cells, turned by atan(step / steps).
Microstructure<2> lattice(int steps, int step, double gap, const Vector<2>& origin) {
  const int discs = steps * steps + step * step;
  const Vector<2> one = {cells * static_cast<double>(steps) / discs, cells * static_cast<double>(step) / discs};
  Microstructure<2> box = {static_cast<double>(cells), Walls::periodic, {}};
  const double diameter = norm(one) / (1.0 + gap);
  for (int i = -discs; i <= discs; ++i) {
    for (int j = -discs; j <= discs; ++j) {
      const Vector<2> centre = {origin[0] + i * one[0] - j * one[1], origin[1] + i * one[1] + j * one[0]};
      const bool is_inside = std::min(centre[0], centre[1]) >= -1e-9 && std::max(centre[0], centre[1]) < cells - 1e-9;
      if (is_inside) box.particles.push_back({centre, diameter});
    }
  }
  return box;
}

/// Discs without coatings, of phase 1.
ParticlesInBox<2> without_coatings(const Microstructure<2>& box) {
  return {as_particles(box), 0, std::vector<ParticlePhases>(box.particles.size(), {.phase = 1})};
}

struct Geometry {
  explicit Geometry(const Microstructure<2>& box)
      : images(without_coatings(box), cells,
               box.walls == Walls::periodic ? Boundary::periodic : Boundary::displacement),
        owners(images),
        faces(images, owners),
        phases(box.particles.size(), {.phase = 1}) {}

  [[nodiscard]] GapGeometry<2> all() const { return {images, owners, faces, 0, phases}; }

  ParticleImages<2> images;
  Owners<2> owners;
  FaceTable faces;
  std::vector<ParticlePhases> phases;
};

/// Calls action(cell) for all cells of the box.
template <class Action>
void for_each_cell(const Action& action) {
  for_each_index(Index<2>{}, Index<2>{cells, cells}, action);
}

TEST(ParticleImages, FindTheTwoThatAreNearestAcrossTheSidesOfTheBox) {
  const Microstructure<2> box = {2.0, Walls::periodic, {{{0.1, 1.0}, 0.6}, {{1.0, 1.0}, 0.4}}};
  const ParticleImages<2> discs(without_coatings(box), cells, Boundary::periodic);  // ten cells a unit of length
  const auto nearest = discs.nearest_two({19.0, 10.0});
  EXPECT_EQ(discs.particle(nearest.first), 0U);
  EXPECT_NEAR(nearest.to_first, -1.0, 1e-12);
  EXPECT_EQ(discs.outline(nearest.first).centre(), (Vector<2>{21.0, 10.0}));
  const auto outside = discs.nearest_two({-3.0, 10.0});
  EXPECT_EQ(discs.outline(outside.first).centre(), (Vector<2>{1.0, 10.0}));
  EXPECT_NEAR(outside.to_first, 1.0, 1e-12);
}

TEST(ParticleImages, LeaveBinderOnALineBetweenThem) {
  const Microstructure<2> box = {20.0, Walls::periodic, {{{9.0, 10.0}, 2.5}, {{11.5, 10.0}, 2.0}}};
  const auto binder = ParticleImages<2>(without_coatings(box), cells, Boundary::periodic).binder_on({{10.0, 10.0}, 0});
  ASSERT_EQ(binder.size(), 1U);
  EXPECT_NEAR(binder[0].begin, 0.25, 1e-12);
  EXPECT_NEAR(binder[0].end, 0.5, 1e-12);
}

TEST(ParticleImages, OfABoxWithWallsUnderAPeriodicBoundaryAreRefused) {
  EXPECT_THROW(ParticleImages<2>(without_coatings({1.0, Walls::hard, {}}), cells, Boundary::periodic), InputError);
}

TEST(ParticleImages, KnowTheWallsOfABoxUnderADisplacementBoundary) {
  const Microstructure<2> box = {20.0, Walls::hard, {{{5.5, 10.0}, 10.0}}};
  const ParticleImages<2> held(without_coatings(box), cells, Boundary::displacement),
      drawn(without_coatings(box), cells, Boundary::traction);
  const auto nearest = held.nearest_two({0.2, 10.0});
  EXPECT_EQ(nearest.first, walls);
  EXPECT_NEAR(nearest.gap(), 0.5, 1e-12);
  EXPECT_EQ(held.normal(walls, {0.2, 10.0}), (Vector<2>{1.0, 0.0}));
  EXPECT_EQ(held.normal(walls, {10.0, 19.5}), (Vector<2>{0.0, -1.0}));
  EXPECT_EQ(drawn.nearest_two({0.2, 10.0}).second, no_image);
  EXPECT_EQ(Owners<2>(held).of({0, 10}), walls);
  EXPECT_TRUE(Owners<2>(drawn).is_free({0, 10}));
  EXPECT_TRUE(Owners<2>(held).is_free({-1, 10}));
}

TEST(Owners, OfNodesInANarrowGapAreTheNearerParticles) {
  // The gap is one cell wide, from 9.6 to 10.6; nodes at 10 lie in it.
  const Microstructure<2> box = {20.0, Walls::periodic, {{{4.6, 10.0}, 10.0}, {{15.6, 10.0}, 10.0}}};
  const ParticleImages<2> discs(without_coatings(box), cells, Boundary::periodic);
  const Owners<2> owners(discs);
  EXPECT_EQ(owners.of({10, 10}), owners.of({9, 10}));
  EXPECT_TRUE(owners.is_in_binder({10, 10}));
  EXPECT_FALSE(owners.is_in_binder({9, 10}));
  EXPECT_NE(owners.of({11, 10}), owners.of({10, 10}));
  EXPECT_TRUE(owners.is_free({10, 16}));
}

// A disc touches the wall; behind it there is no gap, though both are near.
TEST(Owners, OfNodesBehindASmallParticleAreNone) {
  const Microstructure<2> box = {20.0, Walls::hard, {{{0.3, 10.0}, 0.6 - 1e-9}}};
  const ParticleImages<2> images(without_coatings(box), cells, Boundary::displacement);
  EXPECT_TRUE(Owners<2>(images).is_free({1, 10}));
  EXPECT_EQ(Owners<2>(images).of({0, 3}), walls);
}

class AnyLattice : public testing::TestWithParam<std::array<int, 2>> {
 protected:
  [[nodiscard]] Geometry at(double x, double y, double gap) const {
    return Geometry(lattice(GetParam()[0], GetParam()[1], gap, {x, y}));
  }
};

/// The unknowns of a cell in a displacement with these gradients of u_x and of u_y, without flow.
CellUnknowns<2> linear_motion(const CellPlace& place, const std::array<Vector<2>, 2>& gradient) {
  CellUnknowns<2> unknowns = CellUnknowns<2>::Zero();
  for (int node = 0; node < 4; ++node) {
    const Vector<2> x = {static_cast<double>(place.node(node)[0]), static_cast<double>(place.node(node)[1])};
    for (std::size_t axis = 0; axis < 2; ++axis) unknowns[displacement_of<2>(node, axis)] = dot(gradient[axis], x);
  }
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    const auto normal = CellPlace::normal(face);
    for (int end = 0; end < 2; ++end) unknowns[slope_at(face, end)] = gradient[normal][1 - normal];
  }
  return unknowns;
}

// A flux follows a particle up to its surface, so that it is exact for a linear displacement.
TEST_P(AnyLattice, ALinearDisplacementWithoutDilatationChangesNoVolume) {
  for (const double gap : {0.01, 0.05, 0.2}) {
    const auto geometry = at(0.3, 0.1, gap);
    const std::array<Vector<2>, 2> gradient = {{{0.3, 0.7}, {-0.2, -0.3}}};  // of u_x and of u_y
    for_each_cell([&](const Index<2>& cell) {
      const CellPlace place(geometry.all(), cell);
      ASSERT_NEAR(volume_change(place).dot(linear_motion(place, gradient)), 0.0, 1e-13) << cell[0] << ' ' << cell[1];
    });
  }
}

/// Two discs between the walls of a box.
Microstructure<2> between_walls() {
  return {20.0, Walls::hard, {{{5.33, 6.4}, 10.5}, {{14.3, 14.31}, 11.3}}};
}

// Walls follow the load, whose displacement gradient is symmetric, and so do their slopes.
TEST(GapCells, BetweenWallsKeepTheirVolumeInALinearDisplacement) {
  const Geometry geometry(between_walls());
  const std::array<Vector<2>, 2> gradient = {{{0.3, 0.7}, {0.7, -0.3}}};
  int of_walls = 0;
  for_each_cell([&](const Index<2>& cell) {
    const CellPlace place(geometry.all(), cell);
    for (int face = 0; face < faces_of_cell<2>; ++face) {
      for (int end = 0; end < 2; ++end) of_walls += place.is_on_wall(face, end) ? 1 : 0;
    }
    ASSERT_NEAR(volume_change(place).dot(linear_motion(place, gradient)), 0.0, 1e-13) << cell[0] << ' ' << cell[1];
  });
  EXPECT_GT(of_walls, 20);
}

// Nothing flows through sides, and what leaves any other face enters the next cell.
TEST(GapCells, OfABoxWithWallsExchangeVolumeWithOneAnotherAlone) {
  for (const auto boundary : {Boundary::displacement, Boundary::traction}) {
    const auto gap_cells = find_gap_cells(without_coatings(between_walls()), cells, boundary);
    std::vector<double> total(static_cast<std::size_t>(gap_cells.unknowns()), 0.0);
    std::vector<int> seen(total.size(), 0);
    for (const auto& cell : gap_cells.cells()) {
      for (std::size_t k = 0; k < cell.gap_unknowns.size(); ++k) {
        const auto number = cell.gap_unknowns[k];
        if (number == GapCell<2>::none) continue;
        total[static_cast<std::size_t>(number)] += cell.volume[CellShape<2>::dofs + static_cast<Eigen::Index>(k)];
        ++seen[static_cast<std::size_t>(number)];
      }
    }
    ASSERT_FALSE(total.empty());
    for (std::size_t i = 0; i < total.size(); ++i) {
      EXPECT_NEAR(total[i], 0.0, 1e-13);
      EXPECT_EQ(seen[i], 2);
    }
  }
}

// The discs of one row slide past those of the next.
TEST_P(AnyLattice, ParticlesThatSlideChangeNoVolume) {
  const auto [steps, step] = GetParam();
  const double length = std::hypot(steps, step);
  const Vector<2> along = {steps / length, step / length};
  const auto geometry = at(0.3, 0.1, 0.02);
  int found = 0;
  for_each_cell([&](const Index<2>& cell) {
    const CellPlace place(geometry.all(), cell);
    if (place.has_free_node() || !(place.has_one_owner() || place.is_in_chain())) return;
    const auto first = geometry.images.outline(place.owner(0));
    CellUnknowns<2> unknowns = CellUnknowns<2>::Zero();
    for (int node = 0; node < 4; ++node) {
      const auto apart = geometry.images.outline(place.owner(node)).centre() - first.centre();
      const bool is_of_another_row = std::abs(cross(along, apart)) > first.reach();
      for (std::size_t axis = 0; axis < 2; ++axis) {
        unknowns[displacement_of<2>(node, axis)] = is_of_another_row ? along[axis] : 0.0;
      }
    }
    ASSERT_NEAR(volume_change(place).dot(unknowns), 0.0, 1e-12) << cell[0] << ' ' << cell[1];
    ++found;
  });
  EXPECT_GT(found, 50);
}

// The slopes have the rotation of the particle. At 45 degrees there are nodes without a neighbour of their particle
// across a face, whose slopes are tied to zero.
TEST_P(AnyLattice, ParticlesThatTurnTogetherHaveNoEnergy) {
  if (GetParam()[0] == GetParam()[1]) return;
  const auto geometry = at(0.3, 0.1, 0.02);
  for_each_cell([&](const Index<2>& cell) {
    const CellPlace place(geometry.all(), cell);
    CellUnknowns<2> unknowns = CellUnknowns<2>::Zero();
    for (int node = 0; node < 4; ++node) {
      unknowns[displacement_of<2>(node, 0)] = -place.node(node)[1];
      unknowns[displacement_of<2>(node, 1)] = place.node(node)[0];
    }
    for (int face = 0; face < faces_of_cell<2>; ++face) {
      for (int end = 0; end < 2; ++end) unknowns[slope_at(face, end)] = CellPlace::normal(face) == 0 ? -1.0 : 1.0;
    }
    std::vector<SquareTerm<2>> terms;
    tie_slopes(geometry.all(), place, terms);
    add_corner_of_particle(geometry.all(), place, terms);
    for (const auto& term : terms) ASSERT_NEAR(term.form.of(unknowns), 0.0, 1e-12);
    ASSERT_NEAR(volume_change(place).dot(unknowns), 0.0, 1e-12);
  });
}

// Neighbouring cells see the same volume pass through their face.
TEST_P(AnyLattice, WhatLeavesACellEntersItsNeighbour) {
  const auto box = lattice(GetParam()[0], GetParam()[1], 0.02, {0.3, 0.1});
  const auto cells_of_box = find_gap_cells(without_coatings(box), cells, Boundary::periodic);
  std::vector<double> total(static_cast<std::size_t>(cells_of_box.unknowns()), 0.0);
  for (const auto& cell : cells_of_box.cells()) {
    for (std::size_t k = 0; k < cell.gap_unknowns.size(); ++k) {
      const auto number = cell.gap_unknowns[k];
      if (number == GapCell<2>::none) continue;
      total[static_cast<std::size_t>(number)] += cell.volume[CellShape<2>::dofs + static_cast<Eigen::Index>(k)];
    }
  }
  for (const double sum : total) EXPECT_NEAR(sum, 0.0, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Turned, AnyLattice, testing::Values(std::array{2, 0}, std::array{2, 1}, std::array{1, 1}),
                         [](const auto& info) {
                           return info.param[1] == 0 ? "Straight" : info.param[0] == 2 ? "By27Degrees" : "By45Degrees";
                         });

/// Two discs of this radius side by side with a gap between them, around the middle of the box.
Microstructure<2> two_discs(double radius, double gap) {
  const double to_centre = 0.5 * gap + radius;
  return {static_cast<double>(cells),
          Walls::periodic,
          {{{10.0 - to_centre, 10.0}, 2.0 * radius}, {{10.0 + to_centre, 10.0}, 2.0 * radius}}};
}

// A uniform flow q has the energy (g / 2) q^2 times the integral of 12 (1 - 0.3 w) ds / h^3, with the part w along the
// channel of the normals of both particles, squared.
TEST(Channel, OfASmallGapHasTheResistanceOfLubrication) {
  const double radius = 4.0, gap = 0.004;
  const ParticleImages<2> discs(without_coatings(two_discs(radius, gap)), cells, Boundary::periodic);
  const auto nearest = discs.nearest_two({10.0, 10.0});
  const auto left = discs.outline(nearest.first).centre()[0] < 10.0 ? nearest.first : nearest.second;
  const auto right = left == nearest.first ? nearest.second : nearest.first;
  const auto channel = make_channel(discs, left, right, {10.0, 9.5}, {10.0, 10.5});
  double resistance = 0.0, slenderness = 0.0, area = 0.0;  // by the midpoint rule
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double s = -0.5 + (i + 0.5) / steps, ds = 1.0 / steps, to_centre = std::hypot(0.5 * gap + radius, s);
    const double h = 2.0 * (to_centre - radius), wedge = s * s / (to_centre * to_centre);
    resistance += 12.0 * (1.0 - 0.3 * wedge) / (h * h * h) * ds;
    slenderness += ds / h;
    area += h * ds;
  }
  const Eigen::Vector3d uniform(1.0, 1.0, 0.0);
  EXPECT_NEAR(uniform.dot(channel.resistance * uniform) / resistance, 1.0, 0.02);
  EXPECT_NEAR(channel.slenderness / slenderness, 1.0, 1e-3);
  EXPECT_NEAR(channel.area / area, 1.0, 1e-6);
}

// The surface of a coating is that of the particle; a coating of the material of its core makes no difference.
TEST(GapCells, OfCoatedDiscsAreThoseOfLargerOnes) {
  const auto box = lattice(2, 1, 0.02, {0.3, 0.1});
  auto cores = box;
  for (auto& disc : cores.particles) disc.diameter -= 0.5;
  const std::vector<ParticlePhases> discs(box.particles.size(), {.phase = 1}),
      coated(box.particles.size(), {.phase = 1, .coating = 1, .coating_thickness = 0.25}),
      of_two(box.particles.size(), {.phase = 1, .coating = 2, .coating_thickness = 0.25});
  const auto expected = find_gap_cells({as_particles(box), 0, discs}, cells, Boundary::periodic),
             found = find_gap_cells({as_particles(cores), 0, coated}, cells, Boundary::periodic),
             mixed = find_gap_cells({as_particles(cores), 0, of_two}, cells, Boundary::periodic);
  ASSERT_EQ(found.cells().size(), expected.cells().size());
  for (std::size_t i = 0; i < expected.cells().size(); ++i) {
    const auto &one = expected.cells()[i], &other = found.cells()[i];
    ASSERT_EQ(other.shares.size(), one.shares.size());
    for (std::size_t k = 0; k < one.shares.size(); ++k) {
      EXPECT_LT((other.shares[k] - one.shares[k]).abs().maxCoeff(), 1e-9);
    }
    EXPECT_LT((other.volume - one.volume).norm(), 1e-9);
  }
  double of_coating = 0.0;
  for (const auto& cell : mixed.cells()) {
    for (const auto& [phase, fraction] : cell.mixture) of_coating += phase == 2 ? fraction : 0.0;
  }
  const double outer = box.particles.front().diameter, inner = cores.particles.front().diameter;
  const double of_rings = 5.0 * 0.25 * std::numbers::pi * (outer * outer - inner * inner);
  EXPECT_NEAR(of_coating / of_rings, 1.0, 0.05);
}

// Which disc is the first, and where the channel begins, makes no difference.
TEST(Channel, IsTheSameFromBothSides) {
  const ParticleImages<2> discs(without_coatings({20.0, Walls::periodic, {{{5.0, 9.0}, 9.0}, {{14.0, 12.0}, 9.9}}}),
                                cells, Boundary::periodic);
  const Vector<2> begin = {9.2, 11.0}, end = {9.6, 10.2};
  const auto nearest = discs.nearest_two(begin);
  const auto channel = make_channel(discs, nearest.first, nearest.second, begin, end),
             backwards = make_channel(discs, nearest.first, nearest.second, end, begin),
             swapped = make_channel(discs, nearest.second, nearest.first, begin, end);
  const double energy = Eigen::Vector3d(0.7, -0.2, 0.4).dot(channel.resistance * Eigen::Vector3d(0.7, -0.2, 0.4));
  const Eigen::Vector3d reversed(0.2, -0.7, 0.4), other(0.7, -0.2, -0.4);
  EXPECT_NEAR(reversed.dot(backwards.resistance * reversed) / energy, 1.0, 1e-12);
  EXPECT_NEAR(other.dot(swapped.resistance * other) / energy, 1.0, 1e-12);
}

// A cell with binder is never taken for one of a single phase.
TEST_P(AnyLattice, CellsThatAreNotOfOnePhaseAreGapCells) {
  const auto box = lattice(GetParam()[0], GetParam()[1], 0.02, {0.3, 0.1});
  const auto gap_cells = find_gap_cells(without_coatings(box), cells, Boundary::periodic);
  const Geometry geometry(box);
  for_each_cell([&](const Index<2>& cell) {
    const CellPlace place(geometry.all(), cell);
    double filled = 0.0;
    for (const auto image : geometry.images.near(place.centre())) filled += share_of(geometry.all(), place, image);
    const bool is_cut = filled > 1e-6 && filled < 1.0 - 1e-6;
    EXPECT_TRUE(!is_cut || gap_cells.at(cell) != nullptr) << cell[0] << ' ' << cell[1];
  });
}

// Both discs lie in the same direction from some cells, and a disc lies in the middle of one.
TEST(GapCells, OfSmallDiscsHaveShares) {
  const Microstructure<2> box = {20.0, Walls::periodic, {{{3.5, 10.5}, 2.0}, {{6.5, 10.5}, 2.0}, {{15.5, 10.5}, 0.6}}};
  const auto gap_cells = find_gap_cells(without_coatings(box), cells, Boundary::periodic);
  for (const auto& cell : gap_cells.cells()) {
    ASSERT_FALSE(cell.mixture.empty());
    for (const auto& share : cell.shares) EXPECT_TRUE(share.allFinite());
    EXPECT_TRUE(cell.volume.allFinite());
  }
}

TEST(GapCells, OfDiscsThatOverlapAreRefused) {
  const Microstructure<2> box = {20.0, Walls::periodic, {{{5.0, 10.0}, 4.0}, {{8.0, 10.0}, 4.0}}};
  EXPECT_THROW((void)find_gap_cells(without_coatings(box), cells, Boundary::periodic), InputError);
}

TEST(GapCells, OfParticlesWithoutPhasesAreRefused) {
  EXPECT_THROW((void)find_gap_cells({as_particles(two_discs(4.0, 0.1)), 0, {{.phase = 1}}}, cells, Boundary::periodic),
               InputError);
}

}  // namespace
}  // namespace breccia::gaps
