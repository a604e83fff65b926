#include "homogenisation/factor_of_space.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// A study of random particles of this shear modulus [Pa] in a binder that relaxes from 1.1 GPa to 100 MPa.
template <int dim>
Study study_of(double filler) {
  const Material binder = {
      .name = "binder", .density = 1e3, .bulk = PronySeries(3e9), .shear = PronySeries(1e8, {{1.0, 1e9}})};
  Study study;
  study.stages.push_back({.name = "A", .matrix = binder, .side = 1e-2, .cells = 100});
  auto& stage = study.stages.front();
  stage.fillers = {
      {.material = {.name = "filler", .density = 1e3, .bulk = PronySeries(1e10), .shear = PronySeries(filler)}}};
  stage.packing = PackingMethod<dim>(LubachevskyStillingerPacking<dim>{.walls = Walls::periodic});
  study.tests.loads = {TestLoad::isotropic()};
  return study;
}

/// Moduli that are 2 and 5 times that of the binder at 1 ms and at 100 s.
StageFindings moduli_of(const Study& study, Boundary boundary) {
  const auto& binder = std::get<Material>(study.stages.front().matrix).shear;
  TestResult test = {.id = {.load = TestLoad::isotropic(), .boundary = boundary, .grid = TestGrid(100)}};
  for (const auto& [time, ratio] : {std::pair(1e-3, 2.0), {100.0, 5.0}})
    test.modulus.push_back({time, ratio * binder.at(time)});
  StageFindings stage;
  stage.tests = {test};
  return stage;
}

/// The ratios of random spheres to discs, and those of the discs to their binder, in docs/two-or-three-dimensions.md.
TEST(FactorOfSpace, IsAboutTheLargestRatioOfSpheresToDiscs) {
  const auto study = study_of<2>(1e10);
  const auto factor = factor_of_space(study, study.stages.front(), moduli_of(study, Boundary::periodic));
  ASSERT_TRUE(factor);
  EXPECT_EQ(factor->time, 100.0);
  for (const auto& [discs, spheres] :
       {std::array{1.24, 1.32}, {2.20, 2.60}, {3.13, 3.91}, {5.44, 7.10}, {2.99, 3.34}}) {
    const double expected = std::pow(factor->ratio, std::log(discs) / std::log(5.0));
    EXPECT_GE(expected, 0.99 * spheres / discs);
    EXPECT_LE(expected, 1.2 * spheres / discs);
  }
}

// At 100 s nothing is left of a binder of 1 s without equilibrium, and the ratio to it means nothing.
TEST(FactorOfSpace, IsThatBeforeTheBinderHasFlowedAway) {
  auto study = study_of<2>(1e10);
  std::get<Material>(study.stages.front().matrix).shear = PronySeries(0.0, {{1.0, 1e9}});
  const auto factor = factor_of_space(study, study.stages.front(), moduli_of(study, Boundary::periodic));
  ASSERT_TRUE(factor);
  EXPECT_EQ(factor->time, 1e-3);
}

TEST(FactorOfSpace, IsKnownOfStifferParticlesInPeriodicBoxesOfThePlane) {
  const auto soft = study_of<2>(1e6), spheres = study_of<3>(1e10), discs = study_of<2>(1e10);
  EXPECT_FALSE(factor_of_space(soft, soft.stages.front(), moduli_of(soft, Boundary::periodic)));
  EXPECT_FALSE(factor_of_space(spheres, spheres.stages.front(), moduli_of(spheres, Boundary::periodic)));
  EXPECT_FALSE(factor_of_space(discs, discs.stages.front(), moduli_of(discs, Boundary::displacement)));
  auto listed = discs;
  listed.stages.front().packing = PackingMethod<2>(ExplicitPacking<2>{});
  EXPECT_FALSE(factor_of_space(listed, listed.stages.front(), moduli_of(listed, Boundary::periodic)));
}

}  // namespace
}  // namespace breccia
