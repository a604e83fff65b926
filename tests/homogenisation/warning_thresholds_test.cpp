// Tests of each warning on a stage on both sides of its threshold.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "homogenisation/material_warnings.hpp"
#include "homogenisation/separation.hpp"
#include "homogenisation/stage_warnings.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Optional;

const Material matrix_resin{"resin", 1.0, PronySeries(4.0), PronySeries(1.0)};
const Material filler_glass{"glass", 2.0, PronySeries(5.0), PronySeries(3.0)};

/// A box of 10 mm with 200 cells of 50 um and particles of some sizes.
Stage stage_with(const std::vector<double>& diameters, StageMatrix matrix = matrix_resin,
                 const std::string& name = "A") {
  Filler filler;
  filler.material = filler_glass;
  filler.sizes = ListedSizes{diameters};
  return {.name = name,
          .matrix = std::move(matrix),
          .side = 10e-3,
          .cells = 200,
          .fillers = {filler},
          .packing = RegularPacking{}};
}

StageMicrostructure packed_with(double gap, double wall_gap = 1.0) {
  StageMicrostructure packed;
  packed.gap = gap;
  packed.wall_gap = wall_gap;
  return packed;
}

Study study_within(double first_time, double last_time, Mixing mixing = Mixing::points) {
  Study study;
  study.tests.first_time = first_time;
  study.tests.last_time = last_time;
  study.tests.mixing = mixing;
  return study;
}

std::vector<std::string> warnings_at_gap(double gap, double wall_gap = 1.0) {
  const auto stage = stage_with({1e-3});
  return warnings_on(study_within(1.0, 2.0), stage, packed_with(gap, wall_gap));
}

// The threshold is three cells of 50 um.
// In the plane a warning says what keeps flow from the gaps.
TEST(WarningThresholds, OfGapsInSeriesNameFlow) {
  auto study = study_within(1.0, 2.0, Mixing::series);
  const auto warning = [&study] { return warnings_on(study, study.stages.front(), packed_with(50e-6, 1.0)); };
  study.stages = {stage_with({1e-3})};
  EXPECT_THAT(warning(), ElementsAre(EndsWith(R"(tests.mixing = "flow" represents it)")));
  study.tests.methods = {Method::dynamic};
  EXPECT_THAT(warning(), ElementsAre(HasSubstr(R"("flow" represents it (expected method "quasistatic")")));
}

TEST(WarningThresholds, OfGapsInCells) {
  EXPECT_THAT(warnings_at_gap(150e-6), IsEmpty());
  EXPECT_THAT(warnings_at_gap(149.9e-6), ElementsAre(HasSubstr("149.9 um, is 2.998 cells wide; below 3 cells")));
  EXPECT_THAT(warnings_at_gap(1.0, 149.9e-6), ElementsAre(HasSubstr("between particles or to a wall")));
  EXPECT_THAT(warnings_at_gap(50e-6), ElementsAre(HasSubstr("50 um, is 1 cell wide")));
}

/// A cube of 10 mm with 200 cells of 50 um a side and spheres of equal size that fill 30 %.
StageMicrostructure equal_spheres(double diameter, double gap, double wall_gap = 1.0) {
  auto packed = packed_with(gap, wall_gap);
  packed.box = Microstructure<3>{};
  packed.fraction = 0.3;
  packed.interface_per_area = 6.0 * packed.fraction / diameter;
  return packed;
}

// The threshold for mixed cells is 4.5 cells of 50 um across a sphere.
TEST(WarningThresholds, OfCellsAcrossASphere) {
  auto stage = stage_with({1e-3});
  stage.packing = ExplicitPacking<3>{};
  auto study = study_within(1.0, 2.0, Mixing::series);
  study.tests.boundaries = {Boundary::periodic};
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(225e-6, 23e-6)), IsEmpty());
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(224.9e-6, 23e-6)),
              ElementsAre(AllOf(HasSubstr("the mean sphere, 225 um, is 4.5 cells wide, too few to tell the error"),
                                HasSubstr("(cells = 237 would resolve it)"))));
  auto dense = equal_spheres(225e-6, 46e-6);
  dense.fraction = 0.61;
  EXPECT_THAT(warnings_on(study, stage, dense), ElementsAre(HasSubstr("spheres that fill 61 % are close to jamming")));
  study.tests.mixing = Mixing::points;
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(1e-3, 149.9e-6)),
              ElementsAre(HasSubstr("149.9 um, is 2.998 cells wide; below 3 cells")));
}

// Gaps below a cell and a tenth of a diameter, in a matrix whose shear modulus falls below a tenth of its bulk modulus.
TEST(WarningThresholds, OfGapsBetweenSpheres) {
  auto stage = stage_with({1e-3}, Material{"rubber", 1.0, PronySeries(4.0), PronySeries(0.399)});
  stage.packing = PackingMethod<3>(LatticePacking{});
  auto study = study_within(1.0, 2.0, Mixing::series);
  study.tests.boundaries = {Boundary::periodic};
  const auto is_warning = AllOf(HasSubstr("the smallest gap between spheres, 29.9 um, is 0.6 cells wide"),
                                EndsWith(R"(tests.mixing = "flow" represents it)"));
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(0.3e-3, 29.9e-6)), ElementsAre(is_warning));
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(0.3e-3, 30.1e-6)), IsEmpty());
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(2e-3, 50.1e-6)), IsEmpty());
  auto stiffer = stage;
  stiffer.matrix = Material{"resin", 1.0, PronySeries(4.0), PronySeries(0.401)};
  EXPECT_THAT(warnings_on(study, stiffer, equal_spheres(0.3e-3, 29.9e-6)), IsEmpty());
  study.tests.methods = {Method::dynamic};
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(0.3e-3, 29.9e-6)), ElementsAre(Not(HasSubstr("tests.mixing"))));
  study.tests.methods = {Method::quasistatic};
  study.tests.mixing = Mixing::flow;
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(1e-3, 3.1e-6)), IsEmpty());
  EXPECT_THAT(
      warnings_on(study, stage, equal_spheres(1e-3, 2.9e-6)),
      ElementsAre(HasSubstr("the smallest gap between particles is 2.9 um; flow was tested with gaps of 0.3 %")));
}

// Only a wall of prescribed displacement holds a soft matrix in a gap that is narrower than a cell.
TEST(WarningThresholds, OfGapsBetweenSpheresAndWalls) {
  auto stage = stage_with({1e-3});
  stage.packing = ExplicitPacking<3>{};
  auto study = study_within(1.0, 2.0, Mixing::series);
  study.tests.boundaries = {Boundary::traction};
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(1e-3, 51e-6, 1e-6)), IsEmpty());
  study.tests.boundaries = {Boundary::displacement, Boundary::traction};
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(1e-3, 51e-6, 50e-6)), IsEmpty());
  EXPECT_THAT(warnings_on(study, stage, equal_spheres(1e-3, 1.0, 49.9e-6)),
              ElementsAre(AllOf(HasSubstr("the smallest gap of a particle to a wall, 49.9 um, is 0.998 cells wide"),
                                HasSubstr("below 1 cell a nearly incompressible matrix cannot be squeezed out between "
                                          "the wall and the particles"))));
}

// Films between grains need the same number of cells in two and three dimensions.
TEST(WarningThresholds, OfFilmsInSpace) {
  auto stage = stage_with({1e-3});
  stage.packing = ExplicitPacking<3>{};
  auto packed = packed_with(120e-6);
  packed.box = Grains<3>{};
  auto study = study_within(1.0, 2.0, Mixing::series);
  study.tests.boundaries = {Boundary::periodic};
  EXPECT_THAT(warnings_on(study, stage, packed), IsEmpty());
  packed.gap = 119.9e-6;
  EXPECT_THAT(warnings_on(study, stage, packed),
              ElementsAre(HasSubstr("the film between grains, 119.9 um, is 2.398 cells wide; below 2.4 cells")));
}

// 20000 cells a side resolve 1.5 um of 10 mm.
TEST(WarningThresholds, OfCellsThatCanBeAfforded) {
  EXPECT_THAT(warnings_at_gap(1.5001e-6), ElementsAre(HasSubstr("(cells = 19999 would resolve it)")));
  EXPECT_THAT(warnings_at_gap(1.4999e-6), ElementsAre(Not(HasSubstr("would resolve it"))));
}

// A term affects the modulus for about a decade on either side of its time.
TEST(WarningThresholds, OfTimesBesideTheSpectrum) {
  auto material = matrix_resin;
  const auto warnings = [&](double begin, double end) {
    return warnings_of_unknown_times(material, {begin, end}, Abscissa::time);
  };
  material.shear = PronySeries(0.0, {{1e-3, 1.0}, {1.0, 1.0}});
  EXPECT_THAT(warnings(1.001e-4, 9.99), IsEmpty());
  const auto before = HasSubstr("the computed modulus is constant"), after = HasSubstr("has flowed away there");
  EXPECT_THAT(warnings(0.999e-4, 1.0), ElementsAre(before));
  EXPECT_THAT(warnings(1.0, 10.01), ElementsAre(after));
  EXPECT_THAT(warnings(0.999e-4, 10.01), ElementsAre(before, after));
  material.shear = PronySeries(1e-3, {{1e-3, 1.0}, {1.0, 1.0}});
  EXPECT_THAT(warnings(1.0, 1e6), ElementsAre(HasSubstr("right for a rubber")));
  material.shear = PronySeries(1e-3, {{1.0, 1.0}});
  EXPECT_THAT(warnings(1.0, 1e6), IsEmpty()) << "a model with one term";
  material.shear = PronySeries(0.0, {{1.0, 1.0}});
  EXPECT_THAT(warnings(1e-6, 10.0), IsEmpty()) << "a model with one term";
  EXPECT_THAT(warnings(1e-6, 10.01), ElementsAre(after));
  material.shear = PronySeries(1.0);
  EXPECT_THAT(warnings(1e-6, 1e6), IsEmpty());
}

// Poisson's ratio is 0.49999 where K / G = 2.99998 / 0.00006 = 49999.67.
TEST(WarningThresholds, OfPoissonsRatioNearAHalf) {
  auto stage = stage_with({1e-3});
  stage.fillers.clear();
  const auto warnings_with = [&](const PronySeries& bulk, const PronySeries& shear) {
    stage.matrix = Material{"resin", 1.0, bulk, shear};
    return warnings_on_materials(study_within(1.0, 2.0), stage);
  };
  EXPECT_THAT(warnings_with(PronySeries(49999.0), PronySeries(1.0)), IsEmpty());
  EXPECT_THAT(warnings_with(PronySeries(50001.0), PronySeries(1.0)),
              ElementsAre(HasSubstr("Poisson's ratio is 0.49999 before it relaxes")));
}

// Poisson's ratio is below zero at the last time alone: the bulk modulus relaxes from 2 to 1 Pa, the shear modulus
// stays at 2 Pa.
TEST(WarningThresholds, OfPoissonsRatioBelowZeroAtTheLastTime) {
  auto stage = stage_with({1e-3});
  stage.fillers.clear();
  stage.matrix = Material{"resin", 1.0, PronySeries(1.0, {{1.0, 1.0}}), PronySeries(2.0)};
  EXPECT_THAT(warnings_on_materials(study_within(1e-3, 0.1), stage), IsEmpty());
  EXPECT_THAT(warnings_on_materials(study_within(1e-3, 10.0), stage), ElementsAre(HasSubstr("at 10 s, below zero")));
}

TEST(WarningThresholds, OfAFillerAsStiffAsItsBinderAtTheFirstTime) {
  auto stage = stage_with({1e-3});
  stage.matrix = Material{"resin", 1.0, PronySeries(4.0), PronySeries(1.0, {{1.0, 5.0}})};
  EXPECT_THAT(warnings_of_soft_fillers(study_within(1e-3, 10.0), stage),
              ElementsAre(HasSubstr("shear modulus 3 Pa against")));
  EXPECT_THAT(warnings_of_soft_fillers(study_within(2.0, 10.0), stage), IsEmpty()) << "1 + 5 exp(-2) Pa";
  stage.fillers.clear();
  EXPECT_THAT(warnings_of_soft_fillers(study_within(1e-3, 10.0), stage), IsEmpty());
}

/// The warning of a stage with particles of these sizes whose matrix has particles of other sizes.
std::optional<std::string> warning_of_sizes(const std::vector<double>& below, const std::vector<double>& own,
                                            double gap = 1.0) {
  auto study = study_within(1.0, 2.0);
  study.stages = {stage_with(below, matrix_resin, "small"), stage_with({1.0}, EarlierStage{"small"}, "plain"),
                  stage_with(own, EarlierStage{"plain"})};
  study.stages[1].fillers.clear();
  return warning_of_separation(study, study.stages[2], packed_with(gap));
}

// The comparison reaches through a stage without particles.
TEST(WarningThresholds, OfSizesThatAreFiveTimesApart) {
  EXPECT_FALSE(warning_of_sizes({0.2e-3, 0.4e-3}, {2e-3, 3e-3}));
  EXPECT_THAT(
      warning_of_sizes({0.2e-3, 0.4e-3}, {1.99e-3, 3e-3}),
      Optional(AllOf(HasSubstr("its smallest particles, 1.99 mm, are only 5 times as wide as the largest of its "
                               "matrix small, 400 um"),
                     Not(HasSubstr("gap")))));
  EXPECT_THAT(warning_of_sizes({0.4e-3}, {0.4e-3 * 1.04}), Optional(HasSubstr("are no wider than the largest")));
  EXPECT_THAT(warning_of_sizes({0.4e-3}, {0.4e-3 * 1.06}), Optional(HasSubstr("are only 1.1 times as wide")));
}

TEST(WarningThresholds, OfGapsAsWideAsTheParticlesOfTheMatrix) {
  EXPECT_FALSE(warning_of_sizes({0.4e-3}, {2e-3}, 0.4e-3));
  EXPECT_THAT(
      warning_of_sizes({0.4e-3}, {2e-3}, 0.399e-3),
      Optional(HasSubstr("its smallest gap, 399 um, is narrower than the largest of its matrix small, 400 um")));
  EXPECT_THAT(warning_of_sizes({0.4e-3}, {1e-3}, 0.399e-3),
              Optional(HasSubstr(", and its smallest gap, 399 um, is narrower than those")));
}

TEST(WarningThresholds, OfStagesInTheWrongOrder) {
  EXPECT_THAT(warning_of_sizes({0.4e-3}, {0.399e-3}), Optional(HasSubstr("the stages are in the wrong order")));
  EXPECT_THAT(warning_of_sizes({0.4e-3}, {0.1e-3, 0.401e-3}), Optional(Not(HasSubstr("in the wrong order"))))
      << "its largest are wider";
}

TEST(WarningThresholds, OfSizesThatAreNotKnown) {
  auto study = study_within(1.0, 2.0);
  study.stages = {stage_with({0.4e-3}, matrix_resin, "small"), stage_with({0.4e-3}, EarlierStage{"small"})};
  EXPECT_TRUE(warning_of_separation(study, study.stages[1], packed_with(1.0)));
  EXPECT_FALSE(warning_of_separation(study, study.stages[0], packed_with(1.0))) << "its matrix is a material";
  study.stages[0].fillers[0].sizes.reset();
  EXPECT_FALSE(warning_of_separation(study, study.stages[1], packed_with(1.0)));
}

// Two listed sites divide the box of 10 mm into cells of 7.5 and 2.5 mm, which have the areas of discs of 9.8 and 5.6
// mm.
TEST(WarningThresholds, OfListedSitesOfGrains) {
  auto study = study_within(1.0, 2.0);
  study.stages = {stage_with({2e-3}, matrix_resin, "small"), stage_with({}, EarlierStage{"small"})};
  auto& grains = study.stages[1];
  grains.side = 10e-3;
  grains.fillers[0].sizes.reset();
  grains.packing = LaguerrePacking<2>{.film = 1e-3, .sites = {{{3.75e-3, 5e-3}, 0.0}, {{8.75e-3, 5e-3}, -12.5e-6}}};
  EXPECT_THAT(warning_of_separation(study, grains, packed_with(1.0)),
              Optional(HasSubstr("its smallest particles, 5.64 mm, are only 2.8 times as wide as the largest of its "
                                 "matrix small, 2 mm")));
}

}  // namespace
}  // namespace breccia
