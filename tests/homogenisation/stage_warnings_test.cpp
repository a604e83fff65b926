#include "homogenisation/stage_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "homogenisation/narrow_gaps.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const Material resin{.name = "resin", .density = 1.0, .bulk = PronySeries(4.0), .shear = PronySeries(1.0)};

const Material glass{.name = "glass", .density = 2.0, .bulk = PronySeries(5.0), .shear = PronySeries(3.0)};

/// A box of 10 mm with 200 cells of 50 um and two discs.
Stage two_discs(double gap) {
  Filler filler;
  filler.material = glass;
  return {
      .name = "A",
      .matrix = resin,
      .side = 10e-3,
      .cells = 200,
      .fillers = {filler},
      .packing = ExplicitPacking<2>{"discs.csv", std::vector<Disc>{{{2e-3, 2e-3}, 2e-3}, {{4e-3 + gap, 2e-3}, 2e-3}}}};
}

Study within(double first_time, double last_time, Mixing mixing = Mixing::points) {
  Study study;
  study.tests.first_time = first_time;
  study.tests.last_time = last_time;
  study.tests.mixing = mixing;
  return study;
}

std::vector<std::string> warnings(const Stage& stage, const Study& study = within(1.0, 2.0)) {
  return warnings_on(study, stage, make_microstructure(stage));
}

TEST(StageWarnings, OfGapsBelowThreeCells) {
  EXPECT_THAT(warnings(two_discs(0.15e-3)), IsEmpty()) << "three cells";
  EXPECT_THAT(warnings(two_discs(0.1e-3)),
              ElementsAre(AllOf(HasSubstr("A: the smallest gap between particles or to a wall, 100 um, is 2 cells"),
                                HasSubstr("(cells = 300 would resolve it)"))));
  EXPECT_THAT(warnings(two_discs(0.0)), ElementsAre(Not(HasSubstr("would resolve it")))) << "no number of cells does";
}

// The matrix flows through them.
TEST(StageWarnings, OfNarrowGapsAreLackingWithFlow) {
  const auto study = within(1.0, 2.0, Mixing::flow);
  EXPECT_THAT(warnings(two_discs(0.05e-3), study), IsEmpty());
  auto mixed = two_discs(0.05e-3);
  mixed.fillers.push_back(mixed.fillers.front());
  mixed.fillers.back().material.name = "foam";
  mixed.fillers.back().material.shear = PronySeries(1e-3);
  EXPECT_THAT(warnings(mixed, study), Contains(HasSubstr("its cells are in series, without flow through gaps")));
  EXPECT_THAT(warnings(mixed, study), Contains(HasSubstr("squeezed out of the gap")));
}

// A matrix that is stiffer than its particles need not be squeezed out of the gaps between them.
TEST(StageWarnings, OfNarrowGapsAreLackingBetweenSoftParticles) {
  auto soft = two_discs(0.05e-3);
  soft.fillers[0].material.shear = PronySeries(1e-3);
  EXPECT_THAT(warnings(soft, within(1.0, 2.0, Mixing::series)), Not(Contains(HasSubstr("the smallest gap"))));
  EXPECT_THAT(warnings(soft, within(1.0, 2.0, Mixing::flow)), Not(Contains(HasSubstr("its cells are in series"))));
  EXPECT_THAT(warnings(soft, within(1.0, 2.0)), Contains(HasSubstr("the smallest gap"))) << "points";
}

// Of the finest grid, which gives the result of several.
TEST(NarrowGaps, AreThoseBelowOneAndAHalfCells) {
  const auto mixing = [](const Stage& stage, Mixing of_study = Mixing::flow) {
    return mixing_of(within(1.0, 2.0, of_study), stage, make_microstructure(stage));
  };
  EXPECT_EQ(mixing(two_discs(0.07e-3)), Mixing::flow);
  EXPECT_EQ(mixing(two_discs(0.07e-3), Mixing::series), Mixing::series);
  EXPECT_EQ(mixing(two_discs(0.075e-3)), Mixing::series);
  auto two_grids = two_discs(0.1e-3);
  two_grids.coarser_cells = {two_grids.cells / 2};
  EXPECT_EQ(mixing(two_grids), Mixing::series);
}

TEST(StageWarnings, OfGapsBelowOneAndAHalfMixedCells) {
  const auto study = within(1.0, 2.0, Mixing::series);
  EXPECT_THAT(warnings(two_discs(0.075e-3), study), IsEmpty());
  EXPECT_THAT(
      warnings(two_discs(0.05e-3), study),
      ElementsAre(AllOf(HasSubstr("is 1 cell wide; below 1.5 cells a nearly incompressible matrix cannot be "
                                  "squeezed out of the gap"),
                        HasSubstr("(cells = 300 would resolve it)"), Not(HasSubstr("difference of the grids")))));
  auto two_grids = two_discs(0.05e-3);
  two_grids.coarser_cells = {two_grids.cells / 2};
  EXPECT_THAT(warnings(two_grids, study),
              ElementsAre(HasSubstr("; the difference of the grids shows by how much (cells = [")));
}

// The coarsest of several grids has a part in the extrapolation.
TEST(StageWarnings, OfGapsBelowThreeCellsOnTheCoarsestGrid) {
  auto stage = two_discs(0.2e-3);
  EXPECT_THAT(warnings(stage), IsEmpty()) << "four cells";
  stage.coarser_cells = {100};
  EXPECT_THAT(warnings(stage),
              ElementsAre(AllOf(HasSubstr("is 2 cells wide on the coarsest grid, of 100 cells a side;"),
                                HasSubstr("(cells = [150, 300] would resolve it)"))));
}

TEST(StageWarnings, OfAGapOfAboutOneCell) {
  EXPECT_THAT(warnings(two_discs(0.05e-3)), ElementsAre(HasSubstr("is 1 cell wide;")));
  EXPECT_THAT(warnings(two_discs(0.05095e-3)), ElementsAre(HasSubstr("is 1 cell wide;"))) << "1.019 cells";
}

TEST(StageWarnings, OfTimesBeyondTheSpectrum) {
  auto stage = two_discs(0.15e-3);
  auto& shear = std::get<Material>(stage.matrix).shear;
  shear = PronySeries(0.0, {{1e-3, 1.0}, {1.0, 1.0}});
  EXPECT_THAT(warnings(stage, within(1e-4, 10.0)), IsEmpty());
  EXPECT_THAT(
      warnings(stage, within(1e-5, 1.0)),
      ElementsAre(AllOf(HasSubstr("A: times begin at 10 us, more than a decade before"), HasSubstr("resin, 1 ms;"))));
  EXPECT_THAT(warnings(stage, within(1.0, 100.0)),
              ElementsAre(HasSubstr("A: times end at 100 s, more than a decade after")));
  shear = PronySeries(0.0, {{1e-3, 1.0}});
  EXPECT_THAT(warnings(stage, within(1e-5, 1e-2)), IsEmpty()) << "a model with one term";
}

TEST(StageWarnings, OfMeasurementsAtOtherTimes) {
  const auto stage = two_discs(0.15e-3);
  auto study = within(1e-6, 1e-2);
  study.measurements = {{"early", "A", Curve{{1e-3, 2.0}, {1.0, 1.0}}},
                        {"late", "A", Curve{{10.0, 2.0}, {100.0, 1.0}}},
                        {"cut", "A", PronySeries(1.0), TimeWindow{100.0, 200.0}},
                        {"empty", "A", Curve{{10.0, 2.0}, {100.0, 1.0}}, TimeWindow{200.0, 300.0}},
                        {"of another stage", "B", Curve{{10.0, 2.0}, {100.0, 1.0}}}};
  EXPECT_THAT(
      warnings(stage, study),
      ElementsAre(
          "A: 1 of the 2 points of the measurement \"early\" is not compared: it is known from 1 ms to 1 s, and "
          "tests.times go from 1 us to 10 ms",
          "A: the measurement \"late\" is not compared: it is known from 10 s to 100 s, and tests.times "
          "go from 1 us to 10 ms",
          HasSubstr("\"cut\" is not compared: it is known from 100 s to 200 s"),
          "A: the measurement \"empty\" is not compared: none of its own times is within "
          "measurements.times"));
}

TEST(StageWarnings, OfNoPointsOfARelaxationCurveInFrequency) {
  auto study = within(1e-6, 1e-2);
  study.tests.by_frequency = true;
  study.measurements = {{"early", "A", Curve{{1e-3, 2.0}, {1.0, 1.0}}}};
  EXPECT_THAT(warnings(two_discs(0.15e-3), study), IsEmpty());
}

TEST(StageWarnings, OfTimesNotForAMatrixThatIsAStage) {
  auto study = within(1.0, 100.0);
  study.stages = {two_discs(1e-3)};
  study.stages[0].name = "small";
  study.stages[0].fillers.clear();
  auto stage = two_discs(0.15e-3);
  stage.matrix = EarlierStage{"small"};
  EXPECT_THAT(warnings(stage, study), Each(Not(HasSubstr("times reach"))));
}

// The warnings in a study in which a stage of these discs builds on another stage.
std::vector<std::string> warnings_on_second(const std::vector<Disc>& first, const std::vector<Disc>& second) {
  auto study = within(1.0, 2.0);
  study.stages = {two_discs(1e-3), two_discs(1e-3)};
  study.stages[0].name = "small";
  study.stages[1].matrix = EarlierStage{"small"};
  study.stages[0].packed_by<ExplicitPacking<2>>()->particles = first;
  study.stages[1].packed_by<ExplicitPacking<2>>()->particles = second;
  return warnings(study.stages[1], study);
}

TEST(StageWarnings, OfSizesThatAreNotSeparate) {
  const std::vector<Disc> small = {{{5e-3, 5e-3}, 0.4e-3}, {{7e-3, 5e-3}, 0.2e-3}};
  EXPECT_THAT(warnings_on_second(small, {{{3e-3, 5e-3}, 2e-3}, {{7e-3, 5e-3}, 3e-3}}), IsEmpty()) << "five times";
  EXPECT_THAT(
      warnings_on_second(small, {{{3e-3, 5e-3}, 1.6e-3}, {{7e-3, 5e-3}, 3e-3}}),
      ElementsAre(AllOf(HasSubstr("A: its smallest particles, 1.6 mm, are only 4 times as wide as the largest of "
                                  "its matrix small, 400 um"),
                        HasSubstr("Separation of sizes"), Not(HasSubstr("narrower")))));
  EXPECT_THAT(warnings_on_second(small, {{{3e-3, 5e-3}, 2e-3}, {{5.3e-3, 5e-3}, 2e-3}}),
              ElementsAre(AllOf(HasSubstr("A: its smallest gap, 300 um, is narrower than the largest of its matrix"),
                                Not(HasSubstr("times as wide")))));
  EXPECT_THAT(warnings_on_second(small, {{{5e-3, 5e-3}, 0.4e-3}}),
              ElementsAre(HasSubstr("are no wider than the largest of its matrix small, 400 um")))
      << "aluminium and ammonium perchlorate of one size";
}

TEST(StageWarnings, OfStagesInTheWrongOrder) {
  EXPECT_THAT(
      warnings_on_second({{{5e-3, 5e-3}, 2e-3}}, {{{5e-3, 5e-3}, 1e-3}}),
      ElementsAre(AllOf(HasSubstr("A: its particles, up to 1 mm, are smaller than those of its matrix small, up "
                                  "to 2 mm: the stages are in the wrong order"))));
}

// K = 2/3 G is a Poisson's ratio of zero.
TEST(StageWarnings, OfPoissonsRatios) {
  const auto warnings_of = [](const PronySeries& bulk, const PronySeries& shear) {
    auto stage = two_discs(0.15e-3);
    stage.matrix = Material{"resin", 1.0, bulk, shear};
    stage.fillers[0].material = {"glass", 1.0, PronySeries(1e6), PronySeries(1e6)};
    return warnings(stage);
  };
  EXPECT_THAT(warnings_of(PronySeries(2.0), PronySeries(2.99)), IsEmpty());
  EXPECT_THAT(warnings_of(PronySeries(2.0), PronySeries(3.01)),
              ElementsAre(AllOf(HasSubstr("resin: Poisson's ratio is -0.00"), HasSubstr("bulk 2 Pa, shear 3.01 Pa"),
                                HasSubstr("are the units right?"))));
  EXPECT_THAT(warnings_of(PronySeries(1e5), PronySeries(1.0)),
              ElementsAre(HasSubstr("Poisson's ratio is 0.499995 before it relaxes")));
  EXPECT_THAT(warnings_of(PronySeries(1e5), PronySeries(1.0, {{0.1, 1e6}})), IsEmpty()) << "a binder that relaxes";
  EXPECT_THAT(warnings_of(PronySeries(1e5), PronySeries(0.0, {{1e-6, 1e5}})), ElementsAre(HasSubstr("has flowed away")))
      << "one that has relaxed";
}

TEST(StageWarnings, OfAMaterialStandOnce) {
  auto study = within(1.0, 2.0);
  study.stages = {two_discs(1e-3), two_discs(1e-3)};
  study.stages[1].name = "B";
  for (auto& stage : study.stages) stage.matrix = Material{"resin", 1.0, PronySeries(0.1), PronySeries(1.0)};
  EXPECT_THAT(warnings(study.stages[0], study), ElementsAre(HasSubstr("resin: Poisson's ratio")));
  EXPECT_THAT(warnings(study.stages[1], study), IsEmpty());
}

TEST(StageWarnings, OfAFillerSofterThanItsBinder) {
  auto stage = two_discs(0.15e-3);
  stage.fillers[0].material.shear = PronySeries(0.9);
  EXPECT_THAT(warnings(stage), ElementsAre(HasSubstr("A: the filler, glass, is softer than the binder, resin: shear "
                                                     "modulus 900 mPa against 1 Pa at 1 s")));
  stage.fillers[0].material.shear = PronySeries(1.0);
  stage.fillers[0].material.bulk = PronySeries(3.9);
  EXPECT_THAT(warnings(stage), ElementsAre(HasSubstr("bulk modulus 3.9 Pa against 4 Pa")));
}

TEST(StageWarnings, OfBoundariesThatCutParticles) {
  auto stage = two_discs(1e-3);
  auto study = within(1.0, 2.0);
  auto& packing = *stage.packed_by<ExplicitPacking<2>>();
  packing.walls = Walls::periodic;
  EXPECT_THAT(warnings(stage, study), IsEmpty()) << "no disc crosses a side";
  std::get<std::vector<Disc>>(packing.particles)[0].centre[1] = 0.9e-3;
  EXPECT_THAT(warnings(stage, study), ElementsAre(HasSubstr("A: the sides of the box cut filler, over")));
  study.tests.boundaries = {Boundary::periodic};
  EXPECT_THAT(warnings(stage, study), IsEmpty());
}

TEST(StageWarnings, OfTheDeckComeWithTheOthers) {
  auto study = within(1.0, 2.0);
  study.provenance.warnings["A"] = {"the gap follows the grids of a sweep"};
  EXPECT_THAT(warnings(two_discs(0.15e-3), study), ElementsAre("A: the gap follows the grids of a sweep"));
}

TEST(StageWarnings, OfAGapInPointsOnSeveralGrids) {
  auto stage = two_discs(0.3e-3);
  stage.fillers[0].gap = 0.3e-3;
  stage.coarser_cells = {190};
  EXPECT_THAT(warnings(stage), IsEmpty()) << "a length";
  stage.fillers[0].gap_source = GapSource::points;
  EXPECT_THAT(warnings(stage),
              ElementsAre(AllOf(HasSubstr("300 um, follows from the finest grid"), HasSubstr("gap = \"300 um\""))));
  stage.coarser_cells.clear();
  EXPECT_THAT(warnings(stage), IsEmpty()) << "one grid";
}

/// A box of 10 mm that grains fill, of these sizes and with films of one thickness [m].
Stage grains_of(std::optional<Sizes> sizes, double film) {
  Filler filler;
  filler.material = glass;
  filler.sizes = std::move(sizes);
  auto stage = two_discs(0.0);
  stage.fillers = {filler};
  stage.cells = 2000;
  stage.packing = LaguerrePacking<2>{.film = film};
  return stage;
}

Study periodic_study() {
  auto study = within(1.0, 2.0, Mixing::series);
  study.tests.boundaries = {Boundary::periodic};
  return study;
}

// Sizes from 1 to 60, of which equal ratios have equal volumes: in a box of 40 one disc is much of the filler, in the
// box that the warning names none is.
TEST(StageWarnings, OfABoxThatIsTooSmallForItsSizes) {
  Filler filler;
  filler.material = glass;
  filler.sizes = TabulatedSizes{"", {1e-3, 60e-3}, {0.0, 1.0}};
  filler.fraction = 0.3;
  Stage stage = {.name = "A",
                 .matrix = resin,
                 .side = 40e-3,
                 .cells = 200,
                 .fillers = {filler},
                 .packing = PackingMethod<2>(LubachevskyStillingerPacking<2>{Walls::periodic})};
  EXPECT_THAT(warnings(stage),
              Contains(AllOf(HasSubstr("A: the box is too small for its sizes: its largest particle"),
                             HasSubstr("% of the filler, and those up to 60 mm are missing; in a box"),
                             HasSubstr("of 140 mm with some 858 particles none is more than a quarter"),
                             HasSubstr("stages, each the matrix of the next, take far fewer"))));
  stage.side = 140e-3;
  EXPECT_THAT(warnings(stage), Not(Contains(HasSubstr("too small for its sizes"))));
  // A filler of few large particles is no matter beside much of a fine one.
  stage.side = 60e-3;
  stage.fillers.front().sizes = SingleSize{1e-3};
  auto coarse = stage.fillers.front();
  coarse.sizes = TabulatedSizes{"", {5e-3, 6e-3}, {0.0, 1.0}};
  coarse.fraction = 0.02;
  stage.fillers.push_back(coarse);
  EXPECT_THAT(warnings(stage), Not(Contains(HasSubstr("too small for its sizes"))));
}

// The grains have two sizes, 2 and 0.2 mm, the small ones with a hundredth of the area: films of 0.15 mm take up most
// of these.
TEST(StageWarnings, OfGrainsThatTheFilmsTake) {
  std::vector<double> diameters(30, 2e-3);
  diameters.insert(diameters.end(), 30, 0.2e-3);
  auto stage = grains_of(ListedSizes{diameters}, 0.02e-3);
  EXPECT_THAT(warnings(stage, periodic_study()), Not(Contains(HasSubstr("leave nothing")))) << "thin films";
  stage.packed_by<LaguerrePacking<2>>()->film = 0.3e-3;
  EXPECT_THAT(warnings(stage, periodic_study()),
              Contains(AllOf(HasSubstr("films of 300 um leave nothing of 30 of 60 grains"),
                             HasSubstr("little of small ones: a tenth of the area of the grains is below"),
                             HasSubstr("as the particles of an earlier stage"))));
}

// Two listed cells of 10 x 7.5 and 10 x 2.5 mm: films of 3 mm leave only the wider one, and no sizes were requested.
TEST(StageWarnings, OfListedGrainsThatVanish) {
  auto stage = grains_of({}, 3e-3);
  const LaguerreSites<2> bands = {10e-3, Walls::periodic, {{{3.75e-3, 5e-3}, 0.0}, {{8.75e-3, 5e-3}, -12.5e-6}}};
  stage.packed_by<LaguerrePacking<2>>()->sites = bands.sites;
  EXPECT_THAT(warnings(stage, periodic_study()),
              Contains(AllOf(HasSubstr("films of 3 mm leave nothing of 1 of 2 grains"), Not(HasSubstr("asked for")))));
}

}  // namespace
}  // namespace breccia
