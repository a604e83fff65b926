#include "homogenisation/plan/grid_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

/// The largest error of both bounds [-] of boxes like HB-1, between 10 ns and 10 ms, relative to eight or more cells in
/// the narrowest gap; from docs/verification.md, "Cells in a gap".
struct Measured {
  double cells;
  double of_series;
};

constexpr std::array<Measured, 4> measured = {{{1.5, 0.058}, {2.0, 0.031}, {3.0, 0.014}, {4.0, 0.0083}}};

TEST(GridError, IsOfTheSizeOfMeasuredErrors) {
  for (const auto& [cells, of_series] : measured) {
    const auto expected = error_rule_of_gaps(Mixing::series).error_with(cells);
    ASSERT_TRUE(expected);
    EXPECT_GT(*expected, 0.7 * of_series) << cells;
    EXPECT_LT(*expected, 1.3 * of_series) << cells;
  }
}

TEST(GridError, IsUnknownWhereGapsAreBridged) {
  EXPECT_FALSE(error_rule_of_gaps(Mixing::series).error_with(1.49));
  EXPECT_TRUE(error_rule_of_gaps(Mixing::series).error_with(1.5));
  EXPECT_FALSE(error_rule_of_gaps(Mixing::points).error_with(2.9));
  EXPECT_TRUE(error_rule_of_gaps(Mixing::points).error_with(3.0));
}

TEST(GridError, TellsTheCellsForAnError) {
  for (const auto mixing : {Mixing::series, Mixing::points}) {
    for (const double error : {0.04, 0.01, 0.001}) {
      EXPECT_NEAR(error_rule_of_gaps(mixing).error_with(error_rule_of_gaps(mixing).cells_for(error)).value(), error,
                  1e-12);
    }
  }
  EXPECT_EQ(error_rule_of_gaps(Mixing::series).cells_for(0.5), 1.5) << "below that the error may be of any size";
}

/// Largest errors of random packings, by cells across the smallest disc; from docs/gaps-under-a-cell.md.
TEST(GridError, OfFlowIsNoLessThanMeasuredErrors) {
  const auto rule = error_rule_of_flow(2);
  for (const auto& [cells, of_rigid, of_deformable] : {std::array{8.0, 0.039, 0.050}, {16.0, 0.014, 0.020}}) {
    EXPECT_GE(rule.error_with(cells).value(), std::max(of_rigid, of_deformable)) << cells;
    EXPECT_LE(rule.error_with(cells).value(), 1.6 * of_deformable) << cells;
  }
  EXPECT_FALSE(rule.error_with(7.9));
}

/// Largest errors of random packings of spheres, by cells across the smallest one; from docs/gaps-in-space.md.
TEST(GridError, OfFlowInSpaceIsNoLessThanMeasuredErrors) {
  const auto rule = error_rule_of_flow(3);
  for (const auto& [cells, error] :
       {std::array{7.3, 0.071}, {7.8, 0.079}, {8.0, 0.123}, {12.0, 0.091}, {16.0, 0.037}, {20.0, 0.034}}) {
    EXPECT_GE(rule.error_with(cells).value(), error) << cells;
  }
  EXPECT_LE(rule.error_with(12.0).value(), 1.2 * 0.091);
  EXPECT_FALSE(rule.error_with(6.9));
  EXPECT_EQ(rule.error_with(100.0), rule.error_with(20.0)) << "finer grids were not measured";
  EXPECT_TRUE(std::isinf(rule.cells_for(0.01)));
}

/// A cube of 1 mm with 40 cells a side.
Stage stage_of_listed_spheres() {
  Stage stage;
  stage.side = 1e-3;
  stage.cells = 40;
  stage.packing = PackingMethod<3>(ExplicitPacking<3>{});
  return stage;
}

TEST(GridError, OfFlowInSpaceIsThatOfTheSmallestSphereOfARandomPacking) {
  auto stage = stage_of_listed_spheres();
  StageMicrostructure packed;
  Microstructure<3> spheres = {1e-3, Walls::periodic, {}};
  for (int sphere = 0; sphere < 8; ++sphere) spheres.particles.push_back({{5e-4, 5e-4, 5e-4}, 2e-4 + 1e-5 * sphere});
  packed.box = Box<3>(spheres);
  packed.gap = 1e-6;
  EXPECT_NEAR(plan_of_grid(stage, packed, Mixing::flow).value().cells(), 8.0, 1e-9);
  EXPECT_TRUE(plan_of_grid(stage, packed, Mixing::flow).value().error());
  stage.packing = PackingMethod<3>(LatticePacking{});
  EXPECT_FALSE(plan_of_grid(stage, packed, Mixing::flow).value().error()) << "lattices err more";
  stage.packing = PackingMethod<3>(ExplicitPacking<3>{});
  spheres.particles.resize(2);
  packed.box = Box<3>(spheres);
  EXPECT_FALSE(plan_of_grid(stage, packed, Mixing::flow).value().error()) << "a lattice by another name";
}

TEST(GridError, OfSpheresThatAlmostTouchIsNotKnownInSeries) {
  const auto stage = stage_of_listed_spheres();
  StageMicrostructure packed;
  packed.box = Box<3>(Microstructure<3>{1e-3, Walls::periodic, {{{5e-4, 5e-4, 5e-4}, 9e-4}}});
  packed.fraction = 0.38;
  packed.interface_per_area = 6.0 * packed.fraction / 9e-4;
  packed.gap = 20e-6;
  EXPECT_FALSE(plan_of_grid(stage, packed, Mixing::series).value().error());
  packed.gap = 30e-6;
  EXPECT_TRUE(plan_of_grid(stage, packed, Mixing::series).value().error());
}

// Flow through gaps makes their width immaterial.
TEST(GridError, OfFlowIsThatOfTheSmallestDisc) {
  Stage stage;
  stage.side = 1e-3;
  stage.cells = 100;
  StageMicrostructure packed;
  packed.box = Box<2>(Microstructure<2>{1e-3, Walls::hard, {{{3e-4, 3e-4}, 4e-4}, {{7e-4, 7e-4}, 2e-4}}});
  packed.gap = 1e-6;
  const auto plan = plan_of_grid(stage, packed, Mixing::flow).value();
  EXPECT_NEAR(plan.cells(), 20.0, 1e-9);
  EXPECT_NEAR(plan.error().value(), 0.025, 1e-6);
  packed.box = Box<2>(ParticleBox{1e-3, Walls::hard, {{Ellipse{{2e-4, 1e-4}}, Pose({5e-4, 5e-4}, 0.0)}}});
  EXPECT_NEAR(plan_of_grid(stage, packed, Mixing::flow).value().cells(), 10.0 * std::sqrt(2.0), 1e-9)
      << "across a disc of the same area";
}

/// A study of one stage of two discs, in a matrix, by their shear moduli [Pa].
Study study_of_discs(PronySeries matrix, double filler) {
  Stage stage;
  stage.name = "A";
  stage.side = 1e-3;
  stage.cells = 100;
  stage.matrix = Material{.name = "binder", .density = 1e3, .bulk = PronySeries(1e9), .shear = std::move(matrix)};
  stage.fillers = {
      {.material = {.name = "filler", .density = 1e3, .bulk = PronySeries(1e9), .shear = PronySeries(filler)}}};
  Study study;
  study.stages = {stage};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 0.1;
  return study;
}

std::optional<GridPlan> plan_of_discs(const Study& study) {
  StageMicrostructure packed;
  packed.box = Box<2>(Microstructure<2>{1e-3, Walls::hard, {{{3e-4, 3e-4}, 4e-4}, {{7e-4, 7e-4}, 2e-4}}});
  packed.gap = packed.wall_gap = 2e-5;
  return plan_of_grid(study, study.stages.front(), packed);
}

TEST(GridError, OfSoftFillersIsThatOfTheSmallestDisc) {
  const auto stiff = plan_of_discs(study_of_discs(PronySeries(1e6), 1e9)).value();
  const auto soft = plan_of_discs(study_of_discs(PronySeries(1e6), 1e3)).value();
  EXPECT_NEAR(stiff.cells(), 2.0, 1e-9) << "in the gap";
  EXPECT_NEAR(soft.cells(), 20.0, 1e-9) << "across the disc";
}

TEST(GridError, IsUnknownWhereTheBinderFallsFasterThanItsTime) {
  const auto slow = plan_of_discs(study_of_discs(PronySeries(1e5, {{1e-2, 1e5}}), 1e9)).value();
  const auto steep = plan_of_discs(study_of_discs(PronySeries(0.0, {{1e-2, 1e5}}), 1e9)).value();
  EXPECT_TRUE(slow.error());
  EXPECT_FALSE(steep.error());
  EXPECT_EQ(steep.without_rule, "a binder that falls faster than 1/t^2");
}

// The largest errors of grains whose films are narrower than 1.4 cells, docs/gaps-under-a-cell.md.
TEST(GridError, OfNarrowFilmsIsNoLessThanMeasuredErrors) {
  const auto rule = error_rule_of_narrow_films();
  for (const auto& [cells, error] : {std::array{1.2, 0.058}, {0.87, 0.105}, {0.63, 0.087}, {0.38, 0.127}}) {
    EXPECT_GE(rule.error_with(cells).value(), error) << cells;
  }
  EXPECT_FALSE(rule.error_with(0.29));
}

// The largest errors at any stiffness of the binder, from docs/verification.md, "Thin films".
TEST(GridError, OfFilmsIsOfTheSizeOfMeasuredErrors) {
  EXPECT_NEAR(error_rule_of_films().error_with(2.4).value(), 0.051, 0.005);
  EXPECT_NEAR(error_rule_of_films().error_with(4.8).value(), 0.022, 0.002);
  EXPECT_FALSE(error_rule_of_films().error_with(2.3)) << "a soft binder cannot be squeezed out";
  for (const double error : {0.05, 0.01})
    EXPECT_NEAR(error_rule_of_films().error_with(error_rule_of_films().cells_for(error)).value(), error, 1e-12);
  EXPECT_EQ(error_rule_of_films().cells_for(0.5), 2.4);
}

TEST(GridError, KnowsTheSteepestFallOfAMatrix) {
  const TimeWindow times = {1e-3, 0.1};
  EXPECT_EQ(steepest_fall(PronySeries(5.0), times), 0.0);
  EXPECT_NEAR(steepest_fall(PronySeries(0.0, {{1e-2, 5.0}}), times), 10.0, 1e-12) << "exp(-t / 10 ms)";
  // t/tau e^-x / (1 + e^-x) is largest near x = 1.28, with 0.278.
  EXPECT_NEAR(steepest_fall(PronySeries(5.0, {{1e-2, 5.0}}), times), 0.278, 0.005);
  EXPECT_NEAR(steepest_fall(PronySeries(0.0, {{1e-2, 5.0}, {1e-4, 50.0}}), {1.0, 1e3}), 1e5, 1e-6);
}

/// The largest error of the shear modulus [-] of periodic boxes of equal spheres at 40 % between 10 ns and 10 ms, by
/// the cells across a sphere; from docs/verification.md, "Cells across a sphere".
TEST(GridError, OfSpheresIsOfTheSizeOfMeasuredErrors) {
  struct Sphere {
    double cells, error;
  };
  const auto rule = error_rule_of_spheres(0.4);
  ASSERT_TRUE(rule);
  for (const auto& [cells, error] :
       {Sphere{4.75, 0.158}, Sphere{7.125, 0.087}, Sphere{9.5, 0.052}, Sphere{14.25, 0.026}, Sphere{19.0, 0.016}}) {
    const auto expected = rule->error_with(cells);
    ASSERT_TRUE(expected);
    EXPECT_GT(*expected, 0.9 * error) << cells;
    EXPECT_LT(*expected, 1.1 * error) << cells;
  }
  EXPECT_FALSE(rule->error_with(4.4)) << "too few cells to know it";
  EXPECT_FALSE(error_rule_of_spheres(0.61)) << "close to jamming";
  for (const double error : {0.05, 0.01}) EXPECT_NEAR(rule->error_with(rule->cells_for(error)).value(), error, 1e-12);
  EXPECT_EQ(rule->cells_for(0.5), 4.5);
}

/// The location that the plan of a periodic cube of spheres of this fraction names.
std::string place_of_spheres(double fraction) {
  Stage stage;
  stage.packing = PackingMethod<3>();
  stage.side = 1e-3;
  stage.cells = 64;
  StageMicrostructure packed;
  packed.box = Box<3>(Microstructure<3>{});
  packed.fraction = fraction;
  packed.gap = 1e-5;
  packed.interface_per_area = 6.0 * fraction / 2e-4;
  return std::string(plan_of_grid(stage, packed, Mixing::series).value().place);
}

TEST(GridError, OfSpheresSaysWhereItsRuleIsExtrapolated) {
  for (const double measured_share : {0.29, 0.3, 0.4, 0.5}) {
    EXPECT_EQ(place_of_spheres(measured_share), "across the mean sphere") << measured_share;
  }
  for (const double other : {0.1, 0.2, 0.55}) {
    EXPECT_THAT(place_of_spheres(other), testing::HasSubstr("extrapolated")) << other;
  }
}

}  // namespace
}  // namespace breccia
