#include "breccia/homogenisation/stage_discretisation.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "homogenisation/run/packed_stage.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

/// A box of 6 mm with four discs of 2 mm.
const Stage four_discs = test::four_discs("four discs", test::binder, 6e-3, 60);

Stage plain_stage() {
  auto stage = four_discs;
  stage.fillers.clear();
  return stage;
}

Microstructure<2> discs_of(const Stage& stage) {
  return *make_microstructure(stage).content<Microstructure<2>>();
}

TEST(StageDiscretisation, PointsAreOfTheFillerInParticlesAndOfTheMatrixElsewhere) {
  const auto phases = phases_of(four_discs);
  const auto matrix = phases.index_of("matrix"), filler = phases.index_of("filler");
  const auto discretisation = discretise(four_discs, discs_of(four_discs), 60, Mixing::points);
  // A disc has its centre at a quarter of the side: the lower left corner of cell (15, 15).
  EXPECT_EQ(discretisation.cell({15, 15}), (CellPhases<2>{filler, filler, filler, filler}));
  EXPECT_EQ(discretisation.cell({30, 30}), (CellPhases<2>{matrix, matrix, matrix, matrix}));
  const auto fractions = discretisation.fractions(phases.size());
  EXPECT_NEAR(fractions[filler], std::numbers::pi / 9.0, 4e-3);
  EXPECT_NEAR(fractions[matrix], 1.0 - std::numbers::pi / 9.0, 4e-3);
}

TEST(StageDiscretisation, MaterialsAreThoseOfThePhases) {
  const auto phases = phases_of(four_discs);
  const Material softer = {"softer", 900.0, PronySeries(1e9), PronySeries(1e5)};
  const auto materials = materials_of(four_discs, softer);
  ASSERT_EQ(materials.size(), phases.size());
  EXPECT_EQ(materials[phases.index_of("matrix")], softer);
  EXPECT_EQ(materials[phases.index_of("filler")], test::glass);
}

TEST(StageDiscretisation, AStageWithoutFillerIsAllMatrix) {
  const auto stage = plain_stage();
  const auto phases = phases_of(stage);
  EXPECT_THROW(static_cast<void>(phases.index_of("filler")), InputError);
  EXPECT_EQ(materials_of(stage, test::binder), std::vector<Material>{test::binder});
  EXPECT_EQ(discretise(stage, discs_of(stage), 6, Mixing::points).fractions(phases.size()), std::vector<double>{1.0});
}

TEST(StageDiscretisation, RefusesParticlesOfAStageWithoutFiller) {
  EXPECT_THROW(static_cast<void>(discretise(plain_stage(), discs_of(four_discs), 6, Mixing::points)), InputError);
}

TEST(StageDiscretisation, CountsItsPointsWithoutBeingMade) {
  EXPECT_EQ(point_count(four_discs, 60), discretise(four_discs, discs_of(four_discs), 60, Mixing::points).points());
  EXPECT_EQ(point_count(four_discs, 60), 14400U);
}

TEST(PackedStage, KnowsTheShareOfThePointsThatAreFiller) {
  Study study = {.stages = {four_discs}, .tests = {.first_time = 1e-3, .last_time = 1e-2}};
  const auto packed = packed_stage(study, four_discs, make_microstructure(four_discs));
  EXPECT_EQ(packed.points, 14400U);
  EXPECT_NEAR(packed.point_fraction, std::numbers::pi / 9.0, 4e-3);
  const auto plain = plain_stage();
  study.stages = {plain};
  EXPECT_EQ(packed_stage(study, plain, make_microstructure(plain)).point_fraction, 0.0);
}

}  // namespace
}  // namespace breccia
