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

/// Largest errors of 30 random discs with wide gaps in series, 24 cells across each, beside a grid three times as fine
/// (docs/verification.md, "Cells in a gap"). The finer grid has a third of the same error.
TEST(GridError, OfInterfacesIsNoLessThanMeasuredErrors) {
  constexpr double cells = 24.0;
  for (const auto& [fraction, beside_finer] :
       {std::array{0.10, 0.0019}, {0.25, 0.0064}, {0.40, 0.0126}, {0.45, 0.0161}}) {
    const double error = 1.5 * beside_finer, by_rule = error_of_interfaces(fraction) / cells;
    EXPECT_GE(by_rule, 0.99 * error) << fraction;
    EXPECT_LE(by_rule, 2.0 * error) << fraction;
  }
}

TEST(GridError, IsThatOfInterfacesWhereGapsHaveManyCells) {
  const GridPlan wide = {
      .cell_size = 1e-5, .side = 1e-2, .length = 3e-4, .rule = ErrorRule{0.1, 1.8, 1.5}, .interfaces = 60.0};
  EXPECT_NEAR(wide.error().value(), 60.0 * 1e-5, 1e-12);
  EXPECT_EQ(wide.cells_for(0.001), 600.0);
  EXPECT_NEAR(wide.cells_for(0.03).value(), std::ceil(1e-2 / 3e-4 * std::pow(0.1 / 0.03, 1.0 / 1.8)), 1e-9);
}

/// Largest errors of random packings, by cells across the smallest disc; from docs/gaps-under-a-cell.md.
TEST(GridError, OfFlowIsNoLessThanMeasuredErrors) {
  const auto rule = error_rule_of_discs();
  for (const auto& [cells, of_rigid, of_deformable] : {std::array{8.0, 0.039, 0.050}, {16.0, 0.014, 0.020}}) {
    EXPECT_GE(rule.error_with(cells).value(), std::max(of_rigid, of_deformable)) << cells;
    EXPECT_LE(rule.error_with(cells).value(), 1.6 * of_deformable) << cells;
  }
  EXPECT_FALSE(rule.error_with(7.9));
}

/// Largest errors of random packings of spheres, by cells across the smallest one; from docs/gaps-in-space.md.
TEST(GridError, OfFlowInSpaceIsNoLessThanMeasuredErrors) {
  const auto rule = error_rule_of_spheres_with_flow();
  for (const auto& [cells, error] :
       {std::array{7.3, 0.071}, {7.8, 0.079}, {8.0, 0.123}, {12.0, 0.091}, {16.0, 0.037}, {20.0, 0.034}}) {
    EXPECT_GE(rule.error_with(cells).value(), error) << cells;
  }
  EXPECT_LE(rule.error_with(12.0).value(), 1.2 * 0.091);
  EXPECT_FALSE(rule.error_with(6.9));
  EXPECT_EQ(rule.error_with(100.0), rule.error_with(20.0)) << "finer grids were not measured";
  EXPECT_TRUE(std::isinf(rule.cells_for(0.01)));
}

/// The matrix of a study, and its filler of this shear modulus [Pa].
Stage stage_of(PronySeries matrix, double filler) {
  Stage stage;
  stage.name = "A";
  stage.side = 1e-3;
  stage.matrix = Material{.name = "binder", .density = 1e3, .bulk = PronySeries(1e9), .shear = std::move(matrix)};
  stage.fillers = {
      {.material = {.name = "filler", .density = 1e3, .bulk = PronySeries(1e9), .shear = PronySeries(filler)}}};
  return stage;
}

std::optional<GridPlan> plan_of(Stage stage, const StageMicrostructure& packed, Mixing mixing) {
  Study study;
  study.stages = {std::move(stage)};
  study.tests.mixing = mixing;
  study.tests.first_time = 1e-3;
  study.tests.last_time = 0.1;
  return plan_of_grid(study, study.stages.front(), packed);
}

/// A cube of 1 mm with 40 cells a side.
Stage stage_of_spheres() {
  auto stage = stage_of(PronySeries(1e6), 1e9);
  stage.cells = 40;
  stage.packing = PackingMethod<3>(LubachevskyStillingerPacking<3>{.seed = 1});
  return stage;
}

StageMicrostructure packed_spheres(int count) {
  StageMicrostructure packed;
  Microstructure<3> spheres = {1e-3, Walls::periodic, {}};
  for (int sphere = 0; sphere < count; ++sphere) {
    spheres.particles.push_back({{5e-4, 5e-4, 5e-4}, 2e-4 + 1e-5 * sphere});
  }
  packed.box = Box<3>(spheres);
  packed.fraction = 0.5;
  packed.interface_per_area = 6.0 * packed.fraction / 2.3e-4;
  packed.gap = 1e-6;
  return packed;
}

TEST(GridError, OfFlowInSpaceIsThatOfTheSmallestSphereOfARandomPacking) {
  auto stage = stage_of_spheres();
  auto packed = packed_spheres(8);
  const auto plan = plan_of(stage, packed, Mixing::flow).value();
  EXPECT_NEAR(plan.cells(), 8.0, 1e-9);
  EXPECT_TRUE(plan.error());
  EXPECT_EQ(plan.caveat, "of packings of 52 and 55 %");
  packed.gap = 0.0029 * 2.3e-4;
  EXPECT_EQ(plan_of(stage, packed, Mixing::flow).value().without_rule, "particles that touch, or almost");
  packed.gap = 1e-6;
  packed.fraction = 0.62;
  packed.interface_per_area = 6.0 * packed.fraction / 2.3e-4;
  EXPECT_EQ(plan_of(stage, packed, Mixing::flow).value().without_rule, "spheres close to jamming");
  constexpr auto others = "lattices, lists of particles and boxes of fewer than eight";
  EXPECT_EQ(plan_of(stage, packed_spheres(7), Mixing::flow).value().without_rule, others);
  for (const PackingMethod<3>& packing : {PackingMethod<3>(LatticePacking{}), PackingMethod<3>(ExplicitPacking<3>{})}) {
    stage.packing = packing;
    EXPECT_EQ(plan_of(stage, packed_spheres(8), Mixing::flow).value().without_rule, others);
  }
}

TEST(GridError, OfSpheresThatAlmostTouchIsNotKnownInSeries) {
  auto packed = packed_spheres(8);
  packed.gap = 20e-6;
  EXPECT_EQ(plan_of(stage_of_spheres(), packed, Mixing::series).value().without_rule,
            "spheres that almost touch, in series");
  // Gaps wider than a tenth of a diameter put no limit on the cells of an error; in narrower ones it has to be a cell.
  packed.gap = 24e-6;
  const auto wide = plan_of(stage_of_spheres(), packed, Mixing::series).value();
  EXPECT_TRUE(wide.error());
  const double cells = wide.cells_for(0.4).value();
  packed.gap = 1e-3 / (cells + 30.0);
  auto fine = stage_of_spheres();
  fine.cells = 80;
  const auto narrow = plan_of(fine, packed, Mixing::series).value();
  EXPECT_NEAR(narrow.cells_for(0.4).value_or(0.0), cells + 30.0, 1.0);
}

/// A square of 1 mm with 100 cells a side.
Stage stage_of_discs(PronySeries matrix = PronySeries(1e6), double filler = 1e9) {
  auto stage = stage_of(std::move(matrix), filler);
  stage.cells = 100;
  stage.packing = PackingMethod<2>(LubachevskyStillingerPacking<2>{.seed = 1});
  return stage;
}

/// Eight discs, of which the smallest is 0.2 mm wide.
StageMicrostructure packed_discs() {
  StageMicrostructure packed;
  Microstructure<2> discs = {1e-3, Walls::hard, std::vector<Ball<2>>(7, {{3e-4, 3e-4}, 4e-4})};
  discs.particles.push_back({{7e-4, 7e-4}, 2e-4});
  packed.box = Box<2>(discs);
  packed.fraction = 0.5;
  packed.interface_per_area = 4.0 * packed.fraction / 3.5e-4;
  packed.gap = packed.wall_gap = 1e-6;
  return packed;
}

// Flow through gaps makes their width immaterial.
TEST(GridError, OfFlowIsThatOfTheSmallestDisc) {
  auto packed = packed_discs();
  const auto plan = plan_of(stage_of_discs(), packed, Mixing::flow).value();
  EXPECT_NEAR(plan.cells(), 20.0, 1e-9);
  EXPECT_NEAR(plan.error().value(), 0.025, 1e-6);
  packed.gap = 0.0019 * 3.5e-4;
  EXPECT_FALSE(plan_of(stage_of_discs(), packed, Mixing::flow).value().error()) << "almost touching";
}

TEST(GridError, OfFlowIsKnownForRandomPackingsAlone) {
  auto packed = packed_discs();
  auto stage = stage_of_discs();
  stage.packing = PackingMethod<2>(ExplicitPacking<2>{});
  EXPECT_FALSE(plan_of(stage, packed, Mixing::flow).value().error());
}

TEST(GridError, OfPolygonsIsTwiceThatOfEllipses) {
  auto packed = packed_discs();
  const Particle ellipse{Ellipse{{2e-4, 1e-4}}, Pose({5e-4, 5e-4}, 0.0)};
  packed.box = Box<2>(ParticleBox{1e-3, Walls::hard, std::vector(8, ellipse)});
  const auto ellipses = plan_of(stage_of_discs(), packed, Mixing::flow).value();
  EXPECT_NEAR(ellipses.cells(), 10.0 * std::sqrt(2.0), 1e-9) << "across a disc of the same area";
  const ConvexPolygon square({{0.0, 0.0}, {2e-4, 0.0}, {2e-4, 2e-4}, {0.0, 2e-4}});
  packed.box = Box<2>(ParticleBox{1e-3, Walls::hard, std::vector(8, Particle{square, Pose({5e-4, 5e-4}, 0.0)})});
  const auto squares = plan_of(stage_of_discs(), packed, Mixing::flow).value();
  EXPECT_NEAR(squares.error().value() * squares.cells(), 2.0 * ellipses.error().value() * ellipses.cells(), 1e-9);
}

/// The plan of discs with gaps of two cells.
std::optional<GridPlan> plan_with_wide_gaps(const Stage& stage) {
  auto packed = packed_discs();
  packed.gap = packed.wall_gap = 2e-5;
  return plan_of(stage, packed, Mixing::flow);
}

TEST(GridError, OfSoftFillersIsThatOfTheSmallestDisc) {
  EXPECT_NEAR(plan_with_wide_gaps(stage_of_discs(PronySeries(1e6), 1e9)).value().cells(), 2.0, 1e-9) << "in the gap";
  EXPECT_NEAR(plan_with_wide_gaps(stage_of_discs(PronySeries(1e6), 1e3)).value().cells(), 20.0, 1e-9)
      << "across the disc";
}

TEST(GridError, IsUnknownForFillersThatAreSofterThanTheMatrixAtSomeTimes) {
  const PronySeries falling(1e5, {{1e-2, 1e6}});
  EXPECT_EQ(plan_with_wide_gaps(stage_of_discs(falling, 3e5)).value().without_rule,
            "fillers or coatings that are neither stiffer nor softer than the matrix at all times");
}

TEST(GridError, IsUnknownForCoatingsOfLessThanTwoCells) {
  auto stage = stage_of_discs();
  stage.fillers.front().coating = Coating{.material = stage.fillers.front().material, .thickness = 19e-6};
  EXPECT_EQ(plan_with_wide_gaps(stage).value().without_rule, "coatings of less than two cells");
  stage.fillers.front().coating->thickness = 20e-6;
  EXPECT_TRUE(plan_with_wide_gaps(stage).value().error());
}

TEST(GridError, IsUnknownWhereTheBinderFallsFasterThanItsTime) {
  const auto slow = plan_with_wide_gaps(stage_of_discs(PronySeries(1e5, {{1e-2, 1e5}}))).value();
  const auto steep = plan_with_wide_gaps(stage_of_discs(PronySeries(0.0, {{1e-2, 1e5}}))).value();
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
  for (const double error : {0.05, 0.02}) EXPECT_NEAR(rule->error_with(rule->cells_for(error)).value(), error, 1e-12);
  EXPECT_EQ(rule->error_with(100.0), rule->error_with(20.0)) << "finer grids were not measured";
  EXPECT_EQ(rule->cells_for(0.5), 4.5);
}

TEST(GridError, OfSpheresSaysWhereItsRuleIsExtrapolated) {
  const auto caveat_with = [](double fraction) {
    auto packed = packed_spheres(8);
    packed.fraction = fraction;
    packed.interface_per_area = 6.0 * fraction / 2.3e-4;
    packed.gap = 3e-5;
    return plan_of(stage_of_spheres(), packed, Mixing::series).value().caveat;
  };
  for (const double measured_share : {0.29, 0.3, 0.4, 0.5})
    EXPECT_EQ(caveat_with(measured_share), "") << measured_share;
  for (const double other : {0.1, 0.2, 0.55}) {
    EXPECT_THAT(std::string(caveat_with(other)), testing::HasSubstr("extrapolated")) << other;
  }
}

}  // namespace
}  // namespace breccia
