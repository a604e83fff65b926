#include "homogenisation/box/packing_advice.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A box of 1 mm with 60 cells.
Stage box(double diameter, double fraction, double gap, Walls walls = Walls::hard) {
  Filler filler;
  filler.sizes = SingleSize{diameter};
  filler.fraction = fraction;
  filler.gap = gap;
  return {.name = "A",
          .matrix = {},
          .side = 1e-3,
          .cells = 60,
          .fillers = {filler},
          .packing = LubachevskyStillingerPacking<2>{walls, 1}};
}

std::string message_on(const Stage& stage) {
  return test::message_of<NumericalError>([&] { static_cast<void>(make_microstructure(stage)); });
}

/// The number after some words of a message, in its unit, which is um for lengths.
double number_after(const std::string& message, const std::string& words) {
  const auto at = message.find(words);
  EXPECT_NE(at, std::string::npos) << message;
  return at == std::string::npos ? 0.0 : std::stod(message.substr(at + words.size()));
}

/// Packings of one size and of two, of few particles and of many, which are impossible by their density or jam.
std::vector<Stage> impossible_stages() {
  std::vector<Stage> stages;
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    stages.push_back(box(120e-6, 0.44, 60e-6, walls));
    stages.push_back(box(60e-6, 0.6, 20e-6, walls));
    stages.push_back(box(250e-6, 0.5, 90e-6, walls));
  }
  stages.push_back(box(120e-6, 0.35, 56e-6));
  stages.push_back(box(120e-6, 0.35, 68e-6, Walls::periodic));
  auto wide = box(50e-6, 0.7, 25e-6);
  wide.fillers[0].sizes = LognormalSizes{{{1.0, 90e-6, 0.6}}};
  wide.fillers[0].smallest = 40e-6;
  wide.fillers[0].largest = 200e-6;
  stages.push_back(wide);
  return stages;
}

TEST(PackingAdvice, TheRecommendedGapPacks) {
  for (auto stage : impossible_stages()) {
    const auto message = message_on(stage);
    stage.fillers[0].gap = 1e-6 * number_after(message, "; a gap of ");
    EXPECT_GT(stage.fillers[0].gap, 0.0) << message;
    EXPECT_GE(make_microstructure(stage).gap, stage.fillers[0].gap) << message;
  }
}

TEST(PackingAdvice, TheRecommendedFractionPacks) {
  for (auto stage : impossible_stages()) {
    const auto message = message_on(stage);
    stage.fillers[0].fraction = number_after(message, "should pack, and so should a fraction of ");
    EXPECT_GE(make_microstructure(stage).gap, stage.fillers[0].gap) << message;
  }
}

TEST(PackingAdvice, TheRecommendedCellsPackIfTheGapDependsOnTheGrid) {
  auto stage = box(120e-6, 0.35, 50e-6);
  stage.fillers[0].gap_source = GapSource::points;
  const auto message = message_on(stage);
  EXPECT_THAT(message, HasSubstr("gap of 50 um (3 cells of 16.7 um, from 6 points)"));
  stage.cells = static_cast<int>(number_after(message, "(cells = "));
  EXPECT_GT(stage.cells, 60);
  stage.fillers[0].gap = 3.0 * stage.cell_size();
  EXPECT_GE(make_microstructure(stage).gap, stage.fillers[0].gap) << message;
}

TEST(PackingAdvice, ALengthIsNotDerivedFromTheGrid) {
  EXPECT_THAT(message_on(box(120e-6, 0.44, 60e-6)), AllOf(HasSubstr("at a fraction of 0.44 with a gap of 60 um (3.6 "
                                                                    "cells of 16.7 um) cannot be packed"),
                                                          Not(HasSubstr("cells = "))));
}

TEST(PackingAdvice, WithoutAGapAFractionAloneIsNamed) {
  auto stage = box(50e-6, 0.88, 0.0);
  const auto message = message_on(stage);
  EXPECT_THAT(message, AllOf(HasSubstr("with no gap between them jam: they would fill"), Not(HasSubstr("or less ("))));
  stage.fillers[0].fraction = number_after(message, "; a fraction of ");
  EXPECT_NO_THROW(static_cast<void>(make_microstructure(stage))) << message;
}

// Two fillers of which the particles alone would leave room.
TEST(PackingAdvice, NamesTheGapsOfSeveralFillersAndThoseThatPack) {
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    auto stage = box(120e-6, 0.3, 60e-6, walls);
    stage.fillers.push_back(box(60e-6, 0.15, 30e-6).fillers.front());
    const auto message = message_on(stage);
    EXPECT_THAT(message, AllOf(HasSubstr("with half of the gap around each they would fill"),
                               HasSubstr("% without the gaps"), HasSubstr("the gaps take the room: gaps of ")));
    stage.fillers[0].gap = 1e-6 * number_after(message, "gaps of ");
    stage.fillers[1].gap = 1e-6 * number_after(message, "um and ");
    EXPECT_NEAR(stage.fillers[0].gap, 2.0 * stage.fillers[1].gap, 0.1 * stage.fillers[0].gap);
    EXPECT_GE(make_microstructure(stage).gap, stage.fillers[1].gap) << message;
    stage.fillers[0].fraction = 0.8;
    stage.fillers[1].fraction = 0.4;
    EXPECT_THAT(message_on(stage), HasSubstr("; expected fewer or smaller particles"));
  }
}

// Between the walls 100 um remain for two gaps.
TEST(PackingAdvice, AParticleThatDoesNotFit) {
  auto stage = box(0.9e-3, 0.35, 0.2e-3);
  stage.fillers[0].sizes = ListedSizes{{0.9e-3}};
  stage.fillers[0].fraction.reset();
  const auto message = message_on(stage);
  EXPECT_THAT(message, HasSubstr("a particle of 900 um that keeps a gap of 200 um"));
  const double gap = number_after(message, "; a gap of ");
  EXPECT_GE(gap, 49.0);
  EXPECT_LE(gap, 50.0);
  stage.fillers[0].gap = 1e-6 * gap;
  EXPECT_NO_THROW(static_cast<void>(make_microstructure(stage)));
}

/// A hundred discs of 50 mm in a periodic box of 1 m, and a gap that is as wide.
struct HundredDiscs {
  Stage stage = box(0.05, 0.2, 0.05, Walls::periodic);
  PackingRequest request = {
      .side = 1.0, .walls = Walls::periodic, .diameters = std::vector<double>(100, 0.05), .minimum_gap = 0.05};
  HundredDiscs() {
    stage.side = 1.0;
    stage.cells = 100;
  }
};

/// A fraction of the box that a hundred discs of 50 mm fill with so wide a gap.
double hundred_filled_with(double gap) {
  return 100.0 * std::numbers::pi / 4.0 * (0.05 + gap) * (0.05 + gap);
}

// A packing of 96 % of the jammed fraction is possible. A gap of 25.7 mm fills so much, and the advice has two digits.
TEST(PackingAdvice, KeepsAShareOfWhatHasJammed) {
  const HundredDiscs discs;
  const double jammed = hundred_filled_with(0.0257) / 0.96;
  const auto advice = packing_advice<2>(discs.stage, discs.request, {PackingObstacle::jam, jammed, "jam"});
  ASSERT_TRUE(advice.gap);
  EXPECT_NEAR(*advice.gap, 0.025, 1e-12);
  EXPECT_FALSE(advice.cells) << "the gap is a length";
  // 0.2 (0.45006 / 0.7854), less half of a disc, 0.00098.
  ASSERT_TRUE(advice.fraction);
  EXPECT_NEAR(*advice.fraction, 0.11, 1e-12);
}

// Random discs reach 0.82, minus 0.4 times their relative size of 0.1 in a small box.
TEST(PackingAdvice, KeepsToWhatDiscsAtRandomReach) {
  const HundredDiscs discs;
  const auto advice = packing_advice<2>(discs.stage, discs.request, {PackingObstacle::density, 0.9, "too dense"});
  ASSERT_TRUE(advice.gap);
  EXPECT_LE(hundred_filled_with(*advice.gap), 0.78);
  EXPECT_GT(hundred_filled_with(*advice.gap + 0.001), 0.78) << "the next with two digits";
}

// Where the gap is given in cells, half the gap takes twice the number of cells.
TEST(PackingAdvice, NamesCellsWhereTheGapFollowsTheGrid) {
  HundredDiscs discs;
  discs.stage.fillers[0].gap_source = GapSource::points;
  const double jammed = hundred_filled_with(0.0257) / 0.96;
  const auto advice = packing_advice<2>(discs.stage, discs.request, {PackingObstacle::jam, jammed, "jam"});
  EXPECT_EQ(advice.cells, 200);
}

TEST(PackingAdvice, IsNoneWhereNoGapWouldDo) {
  HundredDiscs discs;
  const double jammed = hundred_filled_with(0.0) / 0.97;
  const auto advice = packing_advice<2>(discs.stage, discs.request, {PackingObstacle::jam, jammed, "jam"});
  EXPECT_FALSE(advice.gap);
  discs.stage.fillers[0].fraction.reset();
  EXPECT_FALSE(packing_advice<2>(discs.stage, discs.request, {PackingObstacle::jam, jammed, "jam"}).fraction);
  EXPECT_THAT(message_on<2>(discs.stage, discs.request, {PackingObstacle::jam, jammed, "jam"}),
              HasSubstr("; expected fewer or smaller particles"));
}

/// A box of 1 mm with discs of 120 um whose coatings are 20 um wide.
Stage coated_box(double fraction, double gap) {
  auto stage = box(120e-6, fraction, gap);
  stage.fillers[0].coating = Coating{{"interphase", 1e3, PronySeries(1e9), PronySeries(1e8)}, 20e-6};
  return stage;
}

// With 160 um and the gap in place of 120 um, 44 % become 44 (200/120)^2 = 122 % of the box, and 132 % of the room of
// 960 um in it.
TEST(PackingAdvice, TellsWhatCoatingsFill) {
  auto stage = coated_box(0.44, 40e-6);
  const auto message = message_on(stage);
  EXPECT_THAT(message, HasSubstr("with coatings and half of the gap around each they would fill 13"));
  stage.fillers[0].fraction = number_after(message, "; a fraction of ");
  EXPECT_NO_THROW(static_cast<void>(make_microstructure(stage))) << message;
  EXPECT_THAT(message_on(coated_box(0.6, 0.0)), HasSubstr("with their coatings they would fill 10"));
}

TEST(PackingAdvice, ACoatedParticleThatDoesNotFit) {
  auto stage = coated_box(0.35, 0.1e-3);
  stage.fillers[0].sizes = ListedSizes{{0.88e-3}};
  stage.fillers[0].fraction.reset();
  const auto message = message_on(stage);
  EXPECT_THAT(message, HasSubstr("a particle of 880 um with a coating of 20 um that keeps a gap of 100 um"));
  const double gap = number_after(message, "; a gap of ");
  EXPECT_GE(gap, 39.0);
  EXPECT_LE(gap, 40.0);
  stage.fillers[0].gap = 1e-6 * gap;
  EXPECT_NO_THROW(static_cast<void>(make_microstructure(stage)));
}

}  // namespace
}  // namespace breccia
