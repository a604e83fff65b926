#include "study/chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

TEST(Chain, FindsTheStageThatAStageBuildsOn) {
  const auto study = test::two_stages();
  const auto &fine = study.stages[0], &coarse = study.stages[1];
  EXPECT_EQ(stage_of_matrix(study, fine), nullptr);
  EXPECT_EQ(stage_of_matrix(study, coarse), &fine);
  EXPECT_EQ(binder_of(study, coarse).name, "binder");
  EXPECT_TRUE(serves_as_matrix(study.stages, fine.name));
  EXPECT_FALSE(serves_as_matrix(study.stages, coarse.name));
  EXPECT_EQ(name_of(fine.matrix), "binder");
  EXPECT_EQ(name_of(coarse.matrix), "fine");
}

TEST(Chain, AMatrixIsTestedInShearAndBulk) {
  auto study = test::two_stages();
  EXPECT_THAT(loads_of(study, study.stages[0]), ElementsAre(Load::shear, Load::bulk));
  EXPECT_THAT(loads_of(study, study.stages[1]), ElementsAre(Load::shear));
  study.tests.loads = {Load::bulk, Load::diagonal_shear};
  EXPECT_THAT(loads_of(study, study.stages[0]), ElementsAre(Load::bulk, Load::diagonal_shear, Load::shear));
}

TEST(Chain, TheIsotropicMeanTakesAllShearsOfTheBoxOnce) {
  auto study = test::two_stages();
  study.tests.loads = {TestLoad::isotropic()};
  EXPECT_TRUE(asks_for_isotropic(study.tests));
  EXPECT_EQ(shear_of_material(study.tests), TestLoad::isotropic());
  EXPECT_THAT(loads_of(study, study.stages[0]), ElementsAre(Load::shear, Load::diagonal_shear, Load::bulk));
  EXPECT_THAT(loads_of(study, study.stages[1]), ElementsAre(Load::shear, Load::diagonal_shear));
  study.tests.loads = {Load::bulk, Load::diagonal_shear, TestLoad::isotropic()};
  EXPECT_THAT(loads_of(study, study.stages[1]), ElementsAre(Load::bulk, Load::diagonal_shear, Load::shear));
  study.stages[1].packing = LatticePacking{};
  EXPECT_THAT(loads_of(study, study.stages[1]), ElementsAre(Load::bulk, Load::diagonal_shear, Load::shear,
                                                            Load::shear_yz, Load::shear_zx, Load::axial_shear));
}

TEST(Chain, AStageHasItsGridsFromTheCoarsest) {
  const Stage stage{.name = "A", .matrix = test::binder, .side = 1.0, .cells = 40, .coarser_cells = {10, 20}};
  EXPECT_THAT(stage.grids(), ElementsAre(10, 20, 40));
  EXPECT_EQ(stage.cell_size(), 0.025);
}

}  // namespace
}  // namespace breccia
