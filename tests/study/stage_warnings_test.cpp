#include "breccia/study/stage_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const Material resin{.name = "resin", .density = 1.0, .bulk = PronySeries(1.0), .shear = PronySeries(1.0)};

/// A box of 10 mm with 200 cells of 50 um and two discs.
Stage two_discs(double gap) {
  Filler filler;
  filler.packing = ExplicitPacking{"discs.csv", {{{2e-3, 2e-3}, 2e-3}, {{4e-3 + gap, 2e-3}, 2e-3}}};
  return {.name = "A", .matrix = resin, .side = 10e-3, .cells = 200, .filler = std::move(filler)};
}

Study within(double first_time, double last_time) {
  Study study;
  study.tests.first_time = first_time;
  study.tests.last_time = last_time;
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

TEST(StageWarnings, OfTimesBeyondTheSpectrum) {
  auto stage = two_discs(0.15e-3);
  auto& shear = std::get<Material>(stage.matrix).shear;
  shear = PronySeries(0.0, {{1e-3, 1.0}, {1.0, 1.0}});
  EXPECT_THAT(warnings(stage, within(1e-4, 10.0)), IsEmpty());
  EXPECT_THAT(warnings(stage, within(1e-5, 1.0)),
              ElementsAre(AllOf(HasSubstr("A: times reach from 10 us to 1 s"), HasSubstr("resin, from 1 ms to 1 s"))));
  EXPECT_THAT(warnings(stage, within(1.0, 100.0)), ElementsAre(HasSubstr("times reach from 1 s to 100 s")));
  shear = PronySeries(0.0, {{1e-3, 1.0}});
  EXPECT_THAT(warnings(stage, within(1.0, 100.0)), IsEmpty()) << "a model with one term";
  stage.matrix = EarlierStage{"B"};
  EXPECT_THAT(warnings(stage, within(1.0, 100.0)), IsEmpty());
}

}  // namespace
}  // namespace breccia
