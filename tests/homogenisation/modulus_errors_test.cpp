#include "homogenisation/modulus_errors.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include "homogenisation/sample_error.hpp"

namespace breccia {
namespace {

constexpr double binder_modulus = 1e6;

Material binder() {
  return {.name = "binder", .density = 1e3, .bulk = PronySeries(1e9), .shear = PronySeries(binder_modulus)};
}

/// A test in shear whose modulus is the same at 0.1, 1 and 10 s.
TestResult constant(TestLoad load, Boundary boundary, TestGrid grid, double modulus, double error_estimate = 1e-5) {
  return {.id = {.load = load, .boundary = boundary, .grid = grid},
          .modulus = {{0.1, modulus}, {1.0, modulus}, {10.0, modulus}},
          .error_estimate = error_estimate};
}

/// A stage on two grids, of which the finer one has an error of 4 %.
StageResult on_two_grids(Boundary boundary) {
  StageResult stage;
  stage.name = "A";
  for (const int cells : {50, 100}) stage.tests.push_back(constant(Load::shear, boundary, TestGrid(cells), 2e6));
  auto limit = constant(Load::shear, boundary, TestGrid::extrapolated(), 2e6, std::numeric_limits<double>::quiet_NaN());
  limit.half_bands.assign(limit.modulus.size(), 0.04 * 2e6);
  stage.tests.push_back(limit);
  return stage;
}

TEST(ModulusErrors, HaveTheBandOfTheGridsTheScatterAndTheSolver) {
  auto stage = on_two_grids(Boundary::periodic);
  add_errors(stage, {.one_grid = 0.5, .sample = SampleKind::particles, .effective_particles = 64.0}, binder(), {});
  EXPECT_TRUE(stage.tests[0].errors.empty()) << "the preferred test alone has errors";
  EXPECT_TRUE(stage.tests[1].errors.empty());
  ASSERT_EQ(stage.tests[2].errors.size(), 3U);
  const auto& error = stage.tests[2].errors[1];
  EXPECT_NEAR(error.grid.value(), 0.04, 1e-12);
  EXPECT_EQ(error.sample, sample_error({.sample = SampleKind::particles, .effective_particles = 64.0}, 2,
                                       Boundary::periodic, Load::shear, 2.0));
  EXPECT_EQ(error.solver, 1e-5) << "that of the finest grid";
  EXPECT_EQ(error.matrix, 0.0);
  EXPECT_NEAR(error.whole().value(), std::sqrt(0.04 * 0.04 + *error.sample * *error.sample + 1e-10), 1e-12);
}

TEST(ModulusErrors, TakeTheRuleForOneGrid) {
  StageResult stage;
  stage.name = "A";
  stage.tests = {constant(Load::shear, Boundary::periodic, TestGrid(100), 2e6)};
  add_errors(stage, {.one_grid = 0.07, .sample = SampleKind::whole}, binder(), {});
  EXPECT_EQ(stage.tests[0].errors.at(0).grid, 0.07);
  EXPECT_EQ(stage.tests[0].errors[0].sample, 0.0) << "a regular array has no scatter";
  add_errors(stage, {.sample = SampleKind::whole}, binder(), {});
  EXPECT_FALSE(stage.tests[0].errors.at(0).grid);
  EXPECT_FALSE(stage.tests[0].errors[0].whole());
}

TEST(ModulusErrors, AreNotKnownWhereOneOfTheirPartsIsNot) {
  auto walled = on_two_grids(Boundary::displacement);
  add_errors(walled, {.sample = SampleKind::particles, .effective_particles = 64.0}, binder(), {});
  EXPECT_FALSE(walled.tests[2].errors.at(0).sample) << "the rule holds for periodic boxes";
  EXPECT_FALSE(walled.tests[2].errors[0].whole());

  auto listed = on_two_grids(Boundary::periodic);
  add_errors(listed, {}, binder(), {});
  EXPECT_FALSE(listed.tests[2].errors.at(0).sample) << "an image, or a list of particles";

  auto apart = on_two_grids(Boundary::periodic);
  apart.tests[2].half_bands.assign(3, 3e6);
  add_errors(apart, {.sample = SampleKind::particles, .effective_particles = 64.0}, binder(), {});
  EXPECT_FALSE(apart.tests[2].errors.at(0).grid) << "grids that differ by more than the modulus tell nothing";

  auto dynamic = on_two_grids(Boundary::periodic);
  for (auto& test : dynamic.tests) {
    test.id.method = Method::dynamic;
    test.error_estimate = std::numeric_limits<double>::quiet_NaN();
  }
  add_errors(dynamic, {.sample = SampleKind::particles, .effective_particles = 64.0}, binder(), {});
  EXPECT_FALSE(dynamic.tests[2].errors.at(0).solver);
}

TEST(ModulusErrors, GoOnFromAStageToTheNext) {
  auto first = on_two_grids(Boundary::periodic);
  first.materials = {{Boundary::periodic, Method::quasistatic, {binder(), {0.1, 10.0}, 0.0, 0.0}}};
  add_errors(first, {.sample = SampleKind::particles, .effective_particles = 64.0}, binder(), {});
  const auto of_first = first.tests[2].errors.at(0).whole();
  ASSERT_TRUE(of_first);
  auto second = on_two_grids(Boundary::periodic);
  second.name = "B";
  add_errors(second, {.sample = SampleKind::particles, .effective_particles = 100.0}, EarlierStage{"A"}, {first});
  EXPECT_EQ(second.tests[2].errors.at(0).matrix, of_first);
  EXPECT_GT(second.tests[2].errors[0].whole(), of_first);

  first.tests[2].errors.at(1).grid.reset();
  add_errors(second, {.sample = SampleKind::particles, .effective_particles = 100.0}, EarlierStage{"A"}, {first});
  EXPECT_EQ(second.tests[2].errors.at(0).matrix, of_first);
  EXPECT_FALSE(second.tests[2].errors.at(1).matrix) << "what is not known of the matrix is not known of the composite";
}

/// A stage with both shears of the plane and their mean [Pa].
StageResult with_mean(double shear, double diagonal, double mean) {
  const auto test = [](TestLoad load, double modulus) {
    return constant(load, Boundary::periodic, TestGrid(100), modulus);
  };
  StageResult stage;
  stage.name = "A";
  stage.tests = {test(Load::shear, shear), test(Load::diagonal_shear, diagonal), test(TestLoad::isotropic(), mean)};
  return stage;
}

TEST(ModulusErrors, TakeOfAMatrixWithAMeanOfShearsThatMean) {
  auto first = with_mean(3e6, 1e6, 2e6);
  first.materials = {{Boundary::periodic, Method::quasistatic, {binder(), {0.1, 10.0}, 0.0, 0.0}}};
  add_errors(first, {.one_grid = 0.01, .sample = SampleKind::particles, .effective_particles = 50.0}, binder(), {});
  EXPECT_GT(first.tests[0].errors.at(0).sample, first.tests[2].errors.at(0).sample);
  StageResult second;
  second.name = "B";
  second.tests = {constant(TestLoad::isotropic(), Boundary::periodic, TestGrid(100), 3e6)};
  add_errors(second, {.one_grid = 0.01, .sample = SampleKind::particles, .effective_particles = 50.0},
             EarlierStage{"A"}, {first});
  EXPECT_EQ(second.tests[0].errors.at(0).matrix, first.tests[2].errors.at(0).whole());
}

TEST(ModulusErrors, OfTheMeanOfShearsAreSmallerWhereTheseAreCloseTogether) {
  auto stage = with_mean(2e6, 2e6, 2e6);
  const std::array apart = {1.001, 1.01, 1.0};
  for (std::size_t i = 0; i < apart.size(); ++i) stage.tests[1].modulus[i].modulus *= apart[i];
  const ErrorRules rules{.one_grid = 0.01, .sample = SampleKind::particles, .effective_particles = 50.0};
  const auto rule = sample_error(rules, 2, Boundary::periodic, TestLoad::isotropic(), 2.0).value();
  add_errors(stage, rules, binder(), {});
  const auto sample = [&](std::size_t time) { return stage.tests[2].errors.at(time).sample.value(); };
  EXPECT_NEAR(sample(0), 0.5 * rule, 1e-12) << "no less than half the rule";
  EXPECT_NEAR(sample(1), std::log(1.01) / 0.35, 1e-12);
  EXPECT_NEAR(sample(2), std::log(1.01) / 0.35, 1e-12) << "that they cross says nothing";
  stage.tests[1].modulus[0].modulus *= 1.5;
  add_errors(stage, rules, binder(), {});
  EXPECT_EQ(sample(0), rule) << "no more than the rule";
}

}  // namespace
}  // namespace breccia
