#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/test_rules.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

TEST(DefaultMixing, HasFlowWhereAllStagesSupportIt) {
  auto study = test::two_stages();
  EXPECT_EQ(default_mixing(study), Mixing::flow);
  study.tests.boundaries = {Boundary::displacement};
  EXPECT_EQ(default_mixing(study), Mixing::flow);
}

TEST(DefaultMixing, IsOfPointsWithStandardVolumetricStrains) {
  auto study = test::two_stages();
  study.tests.volumetric = Volumetric::standard;
  EXPECT_EQ(default_mixing(study), Mixing::points);
}

TEST(DefaultMixing, IsInSeriesWhereAStageOrATestDoesNotSupportFlow) {
  const auto mixing_with = [](const auto& change) {
    auto study = test::two_stages();
    change(study);
    return default_mixing(study);
  };
  const auto in_space = [](Study& study) { study.stages.back().packing = PackingMethod<3>(); };
  const auto dynamic = [](Study& study) { study.tests.methods = {Method::quasistatic, Method::dynamic}; };
  const auto other_moduli = [](Study& study) { study.tests.varied = {{.name = test::glass.name}}; };
  const auto periodic_between_walls = [](Study& study) { study.tests.boundaries = {Boundary::periodic}; };
  const auto cut_grains = [](Study& study) {
    study.stages.back().packing =
        PackingMethod<2>(LaguerrePacking<2>{.walls = Walls::hard, .wall_film = WallFilm::none});
  };
  EXPECT_EQ(mixing_with(in_space), Mixing::series);
  EXPECT_EQ(mixing_with(dynamic), Mixing::series);
  EXPECT_EQ(mixing_with(other_moduli), Mixing::series);
  EXPECT_EQ(mixing_with(periodic_between_walls), Mixing::series);
  EXPECT_EQ(mixing_with(cut_grains), Mixing::series);
  EXPECT_EQ(mixing_with([](Study& study) { study.stages.clear(); }), Mixing::series);
}

TEST(DefaultMixing, IsInSeriesInSpaceThoughFlowIsSupported) {
  auto study = test::two_stages();
  study.tests.boundaries = {Boundary::periodic};
  for (auto& stage : study.stages) stage.packing = PackingMethod<3>(LatticePacking{});
  EXPECT_THAT(obstacles_to_flow(study), testing::IsEmpty());
  EXPECT_EQ(default_mixing(study), Mixing::series);
}

}  // namespace
}  // namespace breccia
