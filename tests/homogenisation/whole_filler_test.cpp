#include "homogenisation/whole_filler.hpp"

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

Material material(const std::string& name, double density) {
  return {name, density, PronySeries(2.0), PronySeries(1.0)};
}

Stage stage(const std::string& name, StageMatrix matrix, const std::string& filler, double density) {
  Stage made;
  made.name = name;
  made.matrix = std::move(matrix);
  if (!filler.empty()) {
    made.fillers.emplace_back().material = material(filler, density);
  }
  return made;
}

/// Statistics of stages with one filler each, of these fractions.
std::vector<std::vector<FillerStatistics>> packed(const std::vector<double>& fractions) {
  std::vector<std::vector<FillerStatistics>> all;
  all.reserve(fractions.size());
  for (const double fraction : fractions) all.push_back({{.fraction = fraction}});
  return all;
}

// The first stage has 20 % aluminium (2700 kg/m^3) in a binder (900 kg/m^3). This mixture is 45 % of the second stage,
// around fine ammonium perchlorate (1950 kg/m^3), which in turn is 40 % of the third, around coarse perchlorate: binder
// 0.8 * 0.45 * 0.4 = 0.144, aluminium 0.036, perchlorate 0.55 * 0.4 + 0.6 = 0.82. Masses per volume: 129.6, 97.2 and
// 1599 of 1825.8 kg/m^3.
TEST(WholeFiller, OfAChainOfStagesWithTwoMaterials) {
  Study study;
  study.stages = {stage("al", material("binder", 900.0), "al", 2700.0), stage("fine", EarlierStage{"al"}, "ap", 1950.0),
                  stage("coarse", EarlierStage{"fine"}, "ap", 1950.0)};
  const auto whole = filler_of_the_whole(study, study.stages[2], packed({0.2, 0.55, 0.6}));
  EXPECT_NEAR(whole.fraction, 0.856, 1e-15);
  EXPECT_NEAR(whole.mass_fraction, 1696.2 / 1825.8, 1e-15);
  ASSERT_EQ(whole.materials.size(), 2U);
  EXPECT_EQ(whole.materials[0].material, "al");
  EXPECT_NEAR(whole.materials[0].fraction, 0.036, 1e-15);
  EXPECT_NEAR(whole.materials[0].mass_fraction, 97.2 / 1825.8, 1e-15);
  EXPECT_EQ(whole.materials[1].material, "ap");
  EXPECT_NEAR(whole.materials[1].fraction, 0.82, 1e-15);
  EXPECT_EQ(in_words(whole), "filler of the whole: 85.6 % by volume, 92.9 % by mass (al 5.3 %, ap 87.6 %)");
}

// The fraction of the stages of PBX-9501 is 1 - 0.35 * 0.37 * 0.48.
TEST(WholeFiller, OfPbx9501) {
  Study study;
  study.stages = {stage("HB-1", material("binder", 1480.0), "hmx", 1850.0),
                  stage("HB-2", EarlierStage{"HB-1"}, "hmx", 1850.0),
                  stage("PBX-9501", EarlierStage{"HB-2"}, "hmx", 1850.0)};
  const auto whole = filler_of_the_whole(study, study.stages[2], packed({0.65, 0.63, 0.52}));
  EXPECT_NEAR(whole.fraction, 0.93784, 1e-15);
  EXPECT_EQ(in_words(whole), "filler of the whole: 93.8 % by volume, 95.0 % by mass");
  EXPECT_NEAR(filler_of_the_whole(study, study.stages[0], packed({0.65})).fraction, 0.65, 1e-15);
}

TEST(WholeFiller, AHomogeneousStageAddsNothing) {
  Study study;
  study.stages = {stage("filled", material("binder", 900.0), "ap", 1950.0),
                  stage("top", EarlierStage{"filled"}, "", 0.0)};
  EXPECT_NEAR(filler_of_the_whole(study, study.stages[1], packed({0.3, 0.0})).fraction, 0.3, 1e-15);
  study.stages = {stage("pure", material("binder", 900.0), "", 0.0)};
  const auto none = filler_of_the_whole(study, study.stages[0], packed({0.0}));
  EXPECT_EQ(none.fraction, 0.0);
  EXPECT_EQ(none.mass_fraction, 0.0);
  EXPECT_TRUE(none.materials.empty());
}

TEST(WholeFiller, NeedsTheFractionOfEveryStage) {
  Study study;
  study.stages = {stage("filled", material("binder", 900.0), "ap", 1950.0)};
  EXPECT_THROW(static_cast<void>(filler_of_the_whole(study, study.stages[0], {})), InputError);
}

TEST(WholeFiller, LeavesVoidsOut) {
  Study study;
  study.stages = {stage("a", material("binder", 1000.0), "stone", 2500.0), stage("b", EarlierStage{"a"}, "", 0.0)};
  study.stages[1].fillers.emplace_back().material = void_material();
  const auto whole = filler_of_the_whole(study, study.stages[1], packed({0.5, 0.2}));
  EXPECT_NEAR(whole.porosity, 0.2, 1e-15);
  EXPECT_NEAR(whole.fraction, 0.4, 1e-15);
  EXPECT_NEAR(whole.mass_fraction, 2500.0 / 3500.0, 1e-15);
  EXPECT_EQ(in_words(whole), "filler of the whole: 40.0 % by volume, 71.4 % by mass; voids: 20.0 % by volume");
  study.stages[1].matrix = material("binder", 1000.0);
  EXPECT_EQ(in_words(filler_of_the_whole(study, study.stages[1], packed({0.5, 0.2}))), "voids: 20.0 % by volume");
}

}  // namespace
}  // namespace breccia
