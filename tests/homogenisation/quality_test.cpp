#include "homogenisation/quality.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A test whose modulus is constant.
TestResult constant(Boundary boundary, TestGrid grid, double modulus, double last_time = 1.0) {
  TestResult test{.id = {.boundary = boundary, .grid = grid}};
  for (const double time : logarithmic_times({0.01, last_time}, 20)) test.modulus.push_back({time, modulus});
  return test;
}

TestResult extrapolated(Boundary boundary, double modulus, double half_band) {
  auto test = constant(boundary, TestGrid::extrapolated(), modulus);
  test.half_bands.assign(test.modulus.size(), half_band);
  return test;
}

Stage random_stage() {
  Filler filler{.material = {.name = "filler", .density = 1e3, .bulk = PronySeries(1e9), .shear = PronySeries(1e9)}};
  filler.fraction = 0.35;
  return {.name = "A",
          .matrix = Material{.name = "binder", .density = 1e3, .bulk = PronySeries(1e9), .shear = PronySeries(1e6)},
          .side = 1e-3,
          .cells = 100,
          .coarser_cells = {},
          .fillers = {filler},
          .packing = LubachevskyStillingerPacking<2>{}};
}

Microstructure<2> discs(std::size_t particles) {
  return {1e-3, Walls::hard, std::vector<Disc>(particles, Disc{{5e-4, 5e-4}, 1e-5})};
}

StageResult result_of(std::vector<TestResult> tests, std::size_t particles = 40) {
  StageResult result;
  result.name = "A";
  result.microstructure.fraction = 0.351;
  result.microstructure.gap = 5e-5;
  result.microstructure.wall_gap = 3e-5;
  result.microstructure.box = discs(particles);
  result.tests = std::move(tests);
  return result;
}

TEST(Quality, ReportsTheDistanceOfTheBounds) {
  const auto quality = quality_of(Study{}, random_stage(),
                                  result_of({constant(Boundary::displacement, TestGrid(100), 118.0),
                                             constant(Boundary::traction, TestGrid(100), 100.0)}));
  ASSERT_EQ(quality.loads.size(), 1U);
  ASSERT_EQ(quality.loads[0].times.size(), 3U) << "0.01, 0.1 and 1 s";
  EXPECT_NEAR(*quality.loads[0].times[1].distance(), 0.18, 1e-12);
  EXPECT_FALSE(quality.loads[0].times[1].grid_half_band);
  EXPECT_NEAR(quality.gap_cells, 3.0, 1e-12) << "that to the wall is the narrowest";
  EXPECT_EQ(
      summary_of(quality),
      "displacement and traction 18 % apart at 10 ms, 18 % at 1 s; grid: one grid, error up to about 1.4 % by a rule "
      "(cells = [50, 100] measures it); narrowest gap: 3 cells; packing: one seed, scatter unknown");
}

TEST(Quality, ReportsAFactorIfBoundsAreFarApart) {
  const auto summary = summary_of(quality_of(Study{}, random_stage(),
                                             result_of({constant(Boundary::displacement, TestGrid(100), 30.0),
                                                        constant(Boundary::traction, TestGrid(100), 2.0)})));
  EXPECT_THAT(summary, HasSubstr("displacement and traction a factor of 15 at 10 ms, a factor of 15 at 1 s;"));
}

TEST(Quality, NamesTheLoadAndTheMethodOfTheBoundsAmongSeveral) {
  const auto other = [](TestResult test, Load load, Method method) {
    test.id.load = load;
    test.id.method = method;
    return test;
  };
  const auto upper = constant(Boundary::displacement, TestGrid(100), 118.0),
             lower = constant(Boundary::traction, TestGrid(100), 100.0),
             lowest = constant(Boundary::displacement, TestGrid(100), 80.0);
  const auto summary_with = [&](const TestResult& further) {
    return summary_of(quality_of(Study{}, random_stage(), result_of({upper, lower, further})));
  };
  EXPECT_THAT(summary_with(other(upper, Load::bulk, Method::quasistatic)),
              StartsWith("displacement and traction under shear 18 % apart at"));
  EXPECT_THAT(summary_with(other(upper, Load::shear, Method::dynamic)),
              StartsWith("displacement and traction under shear, quasistatic 18 % apart at"));
  const auto crossed = result_of(
      {upper, lower, other(lowest, Load::bulk, Method::quasistatic), other(lower, Load::bulk, Method::quasistatic)});
  EXPECT_THAT(summary_of(quality_of(Study{}, random_stage(), crossed)),
              StartsWith("displacement and traction under bulk: the modulus under displacement is 20 % below that "
                         "under traction at 10 ms"));
}

TEST(Quality, SaysOfFilmsWhichKeyHalvesTheirMesh) {
  StageQuality films;
  films.particles = 40;
  films.fraction = 0.9;
  films.gap_cells = std::numeric_limits<double>::infinity();
  EXPECT_THAT(
      summary_of(films),
      HasSubstr(
          "films: error of the mesh unknown (a run with tests.films.face_share = 0.15 shows it by the difference)"));
}

TEST(Quality, TellsDistancesWithTwoDigits) {
  const auto bounds_of = [](double upper, double lower) {
    const auto summary = summary_of(quality_of(Study{}, random_stage(),
                                               result_of({constant(Boundary::displacement, TestGrid(100), upper),
                                                          constant(Boundary::traction, TestGrid(100), lower)})));
    return summary.substr(0, summary.find(" at 10 ms"));
  };
  EXPECT_EQ(bounds_of(1.0009, 1.0), "displacement and traction less than 0.1 % apart");
  EXPECT_EQ(bounds_of(1.0011, 1.0), "displacement and traction 0.11 % apart");
  EXPECT_EQ(bounds_of(1.994, 1.0), "displacement and traction 99 % apart");
  EXPECT_EQ(bounds_of(2.001, 1.0), "displacement and traction a factor of 2");
  EXPECT_EQ(bounds_of(99.4, 1.0), "displacement and traction a factor of 99");
  EXPECT_EQ(bounds_of(1234.0, 1.0), "displacement and traction a factor of 1234");
}

TEST(Quality, KnowsNoDistanceOfASingleBound) {
  EXPECT_FALSE((BoundsAtTime{1.0, 4.0, std::nullopt, 0.5}).distance());
}

TEST(Quality, TakesTheLimitOfSeveralGridsAndItsBand) {
  auto stage = random_stage();
  stage.coarser_cells = {50};
  const auto quality = quality_of(
      Study{}, stage,
      result_of({constant(Boundary::displacement, TestGrid(50), 140.0),
                 constant(Boundary::displacement, TestGrid(100), 130.0),
                 extrapolated(Boundary::displacement, 120.0, 6.0), constant(Boundary::traction, TestGrid(50), 110.0),
                 constant(Boundary::traction, TestGrid(100), 105.0), extrapolated(Boundary::traction, 100.0, 2.0)}));
  EXPECT_NEAR(*quality.loads.at(0).times.front().distance(), 0.2, 1e-12);
  EXPECT_EQ(quality.loads.at(0).times.front().grid_half_band, 6.0);
  EXPECT_THAT(quality.grids, ElementsAre(50, 100));
  EXPECT_THAT(summary_of(quality), HasSubstr("grid: error up to 5 %;")) << "6 of 120, and 2 of 100";
}

// The first time belongs to the last frequency: 1 / (2 pi 1 s) is 159 mHz.
TEST(Quality, SpeaksOfFrequenciesInAStudyOfThem) {
  Study study;
  study.tests.by_frequency = true;
  const auto result = result_of(
      {constant(Boundary::displacement, TestGrid(100), 120.0), constant(Boundary::traction, TestGrid(100), 100.0)});
  const auto in_time = summary_of(quality_of(Study{}, random_stage(), result));
  const auto in_frequency = summary_of(quality_of(study, random_stage(), result));
  EXPECT_THAT(in_time, HasSubstr("displacement and traction 20 % apart at "));
  EXPECT_THAT(in_time, Not(HasSubstr("Hz")));
  EXPECT_THAT(in_frequency,
              testing::ContainsRegex("displacement and traction 20 % apart at [0-9.]+ m?Hz, 20 % at [0-9.]+ k?Hz"));
}

TEST(Quality, ReportsUnknownErrors) {
  Study study;
  study.stages = {random_stage()};
  study.stages.front().name = "fine";
  auto stage = random_stage();
  stage.packing = RegularPacking{};
  stage.matrix = EarlierStage{"fine"};
  const auto upper =
      summary_of(quality_of(study, stage, result_of({constant(Boundary::displacement, TestGrid(100), 1.0)})));
  EXPECT_THAT(upper, HasSubstr("displacement and traction: only displacement, distance unknown"));
  EXPECT_THAT(upper, HasSubstr("matrix: the errors of stage fine add to these"));
  EXPECT_THAT(upper, Not(HasSubstr("seed"))) << "there is one regular packing";
  EXPECT_THAT(summary_of(quality_of(study, stage, result_of({}))), HasSubstr("displacement and traction: not tested"));
  auto empty = result_of({}, 0);
  empty.microstructure.fraction = 0.0;
  EXPECT_EQ(summary_of(quality_of(study, stage, empty)), "") << "without particles";
  empty.microstructure.fraction = 0.5;
  EXPECT_THAT(summary_of(quality_of(study, stage, empty)), HasSubstr("displacement and traction: not tested"))
      << "pixels of an image";
}

TEST(Quality, BoundsAreComparedAtTheTimesOfBoth) {
  const auto bounds = bounds_of_tests(result_of({constant(Boundary::displacement, TestGrid(100), 2.0, 10.0),
                                                 constant(Boundary::traction, TestGrid(100), 1.0, 1.0)}));
  EXPECT_EQ(bounds.at(0).times.back().time, 1.0);
}

TEST(Quality, WarnsOfFewParticlesAndOfAnotherFraction) {
  Study study;
  auto stage = random_stage();
  auto packed = result_of({}, 30).microstructure;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), IsEmpty());
  packed.box = discs(29);
  EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("only 29 particles in the box")));
  study.tests.accuracy = 0.05;
  study.tests.boundaries = {Boundary::periodic};
  packed.effective_particles = 29.0;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), IsEmpty()) << "a rule judges them";
  auto bonded = stage;
  bonded.bonds.emplace();
  EXPECT_THAT(warnings_on_packing(study, bonded, packed), ElementsAre(HasSubstr("only 29 particles"))) << "no rule";
  study.tests.boundaries = {Boundary::periodic, Boundary::traction};
  EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("only 29 particles"))) << "nor here";
  study.tests.boundaries = {Boundary::periodic};
  packed.box = discs(2);
  packed.effective_particles = 2.0;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("only 2 particles")))
      << "no rule for so few";
  study.tests.accuracy.reset();
  packed = result_of({}, 30).microstructure;
  packed.fraction = 0.377;
  EXPECT_THAT(warnings_on_packing(study, stage, packed),
              ElementsAre(HasSubstr("fill 37.7 % of the box where 35 % were asked for")));
  packed.fraction = 0.3599;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), IsEmpty()) << "within 1 % of the box";
  packed.fraction = 0.3401;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), IsEmpty());
  for (const double fraction : {0.3601, 0.3399}) {
    packed.fraction = fraction;
    EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("where 35 % were asked for")))
        << fraction;
  }
  stage.fillers[0].fraction = 0.1;
  for (const double fraction : {0.1051, 0.0949}) {
    packed.fraction = fraction;
    EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("where 10 % were asked for")))
        << fraction;
  }
  packed.fraction = 0.1049;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), IsEmpty()) << "within a twentieth";
  stage.fillers[0].fraction = 0.35;
  packed.box = discs(1);
  packed.fraction = 0.35;
  EXPECT_THAT(warnings_on_packing(study, stage, packed), ElementsAre(HasSubstr("only 1 particle in the box")));
  auto without_fraction = stage;
  without_fraction.fillers[0].fraction.reset();
  packed = result_of({}, 30).microstructure;
  packed.fraction = 0.9;
  EXPECT_THAT(warnings_on_packing(study, without_fraction, packed), IsEmpty());
  EXPECT_THAT(warnings_on_packing(study, {.name = "plain", .matrix = Material{}, .side = 1e-3, .cells = 10}, {}),
              IsEmpty());
  auto regular = stage;
  regular.packing = RegularPacking{};
  packed = result_of({}, 4).microstructure;
  EXPECT_THAT(warnings_on_packing(study, regular, packed), IsEmpty());
}

TEST(Quality, PeriodicTestsHaveAGridErrorAndNoBounds) {
  auto stage = random_stage();
  const auto alone = quality_of(Study{}, stage, result_of({constant(Boundary::periodic, TestGrid(100), 100.0)}));
  EXPECT_THAT(summary_of(alone), StartsWith("grid: one grid, error up to about 1.4 %"));
  // With one cell in the narrowest gap the error may be of any size.
  auto narrow = result_of({constant(Boundary::periodic, TestGrid(100), 100.0)});
  narrow.microstructure.wall_gap = 1e-5;
  EXPECT_THAT(summary_of(quality_of(Study{}, stage, narrow)),
              HasSubstr("grid: one grid, error unknown, too few cells for a rule (cells = [50, 100] measures it)"));
  stage.coarser_cells = {50};
  const auto periodic = quality_of(
      Study{}, stage,
      result_of({constant(Boundary::periodic, TestGrid(50), 110.0), constant(Boundary::periodic, TestGrid(100), 105.0),
                 extrapolated(Boundary::periodic, 100.0, 7.0)}));
  EXPECT_NEAR(periodic.grid_share.value(), 0.07, 1e-12);
  EXPECT_THAT(summary_of(periodic), StartsWith("grid: error up to 7 %; "));
  const auto apart = quality_of(Study{}, stage, result_of({extrapolated(Boundary::periodic, 100.0, 100.0)}));
  EXPECT_THAT(summary_of(apart), HasSubstr("grid: error of any size, since the grids differ too much"));
  const auto unfinished = quality_of(Study{}, stage, result_of({constant(Boundary::periodic, TestGrid(50), 110.0)}));
  EXPECT_THAT(summary_of(unfinished), HasSubstr("grid: error unknown until every grid is tested; ")) << "two grids";
}

TEST(Quality, BeginsWithTheLargestWholeErrorWhereItIsKnown) {
  auto stage = random_stage();
  stage.coarser_cells = {50};
  auto test = extrapolated(Boundary::periodic, 100.0, 3.0);
  test.errors.assign(test.modulus.size(), {.grid = 0.03, .sample = 0.04, .solver = 0.0, .matrix = 0.0});
  test.errors.back().sample = 0.072;
  const auto known = quality_of(Study{}, stage, result_of({test}));
  EXPECT_NEAR(known.error.value(), 0.078, 1e-12);
  EXPECT_THAT(summary_of(known), StartsWith("error up to 7.8 %; grid: error up to 3 %; "));
  EXPECT_THAT(summary_of(known), EndsWith("packing: one seed, error up to about 7.2 % by a rule"));
  test.errors.front().sample.reset();
  const auto unknown = summary_of(quality_of(Study{}, stage, result_of({test})));
  EXPECT_THAT(unknown, StartsWith("grid: error up to 3 %; "));
  EXPECT_THAT(unknown, EndsWith("packing: one seed, scatter unknown"));
}

TEST(Quality, TheErrorsAreThoseOfThePeriodicBoundaryBesideOthers) {
  auto stage = random_stage();
  stage.coarser_cells = {50};
  auto periodic = extrapolated(Boundary::periodic, 110.0, 11.0);
  periodic.errors.assign(periodic.modulus.size(), {.grid = 0.1, .sample = 0.0, .solver = 0.0, .matrix = 0.0});
  const auto others =
      std::vector{extrapolated(Boundary::displacement, 120.0, 24.0), extrapolated(Boundary::traction, 100.0, 2.0)};
  const auto beside = quality_of(Study{}, stage, result_of({others[0], others[1], periodic}));
  EXPECT_NEAR(beside.grid_share.value(), 0.1, 1e-12);
  EXPECT_THAT(summary_of(beside),
              StartsWith("error up to 10 % under the periodic boundary; displacement and traction 20 % "
                         "apart at 10 ms"));
  EXPECT_THAT(summary_of(beside),
              HasSubstr("; grid: error up to 10 % under the periodic boundary, up to 20 % under the others;"));
  const auto alone = quality_of(Study{}, stage, result_of(others));
  EXPECT_NEAR(alone.grid_share.value(), 0.2, 1e-12) << "of all tests";
  EXPECT_THAT(summary_of(alone), HasSubstr("; grid: error up to 20 %;"));
}

TEST(Quality, GivesTheNarrowestGapOnEachGrid) {
  auto stage = random_stage();
  stage.coarser_cells = {50};
  EXPECT_THAT(summary_of(quality_of(Study{}, stage, result_of({}))), HasSubstr("; narrowest gap: 1.5 and 3 cells;"));
  stage.coarser_cells = {25, 50};
  EXPECT_THAT(summary_of(quality_of(Study{}, stage, result_of({}))),
              HasSubstr("; narrowest gap: 0.75, 1.5 and 3 cells;"));
}

// The sum of the half bands of both bounds is at most twice the larger one.
TEST(Quality, BoundsAreCrossedBeyondTheirBands) {
  EXPECT_FALSE((BoundsAtTime{1.0, 90.0, 100.0, 5.0}).crossing()) << "within the error of the grids";
  EXPECT_NEAR((BoundsAtTime{1.0, 89.0, 100.0, 5.0}).crossing().value(), 0.11, 1e-12);
  EXPECT_FALSE((BoundsAtTime{1.0, 99.95, 100.0, std::nullopt}).crossing()) << "a rounding error";
  EXPECT_NEAR((BoundsAtTime{1.0, 99.0, 100.0, std::nullopt}).crossing().value(), 0.01, 1e-12);
  EXPECT_FALSE((BoundsAtTime{1.0, 100.0, 99.0, std::nullopt}).crossing());
  EXPECT_FALSE((BoundsAtTime{1.0, std::nullopt, 99.0, std::nullopt}).crossing());
}

TEST(Quality, SaysThatBoundsAreCrossed) {
  auto stage = random_stage();
  stage.coarser_cells = {50};
  auto falling = extrapolated(Boundary::displacement, 120.0, 6.0);
  for (auto& sample : falling.modulus) sample.modulus = sample.time > 0.5 ? 80.0 : 120.0;
  const auto quality = quality_of(Study{}, stage, result_of({falling, extrapolated(Boundary::traction, 100.0, 2.0)}));
  EXPECT_THAT(
      summary_of(quality),
      StartsWith(
          "displacement and traction: the modulus under displacement is 20 % below that under traction at 1 s; "));
  EXPECT_THAT(
      warnings_on_bounds(quality),
      ElementsAre(
          "shear, quasistatic: the modulus under displacement is 20 % below that under traction at 1 s; likely causes: "
          "grids too coarse for the narrowest gap, in cells 1.5 wide with cells = 50, 3 wide with "
          "cells = 100; or particles that the sides of the box cut"));
  const auto sound = quality_of(
      Study{}, stage,
      result_of({extrapolated(Boundary::displacement, 120.0, 6.0), extrapolated(Boundary::traction, 100.0, 2.0)}));
  EXPECT_THAT(warnings_on_bounds(sound), IsEmpty());
}

}  // namespace
}  // namespace breccia
