#include "homogenisation/run/isotropic_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "homogenisation/anisotropy.hpp"
#include "homogenisation/run/stage_extrapolation.hpp"
#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The relaxation modulus 1 + m exp(-t / 10 ms) Pa.
TestResult relaxing(Load load, double m, int cells = 20, Boundary boundary = Boundary::displacement) {
  TestResult test{.id = {.load = load, .boundary = boundary, .grid = TestGrid(cells)},
                  .series = PronySeries(1.0, {{1e-2, m}}),
                  .error_estimate = 1e-6 * m};
  for (const double time : logarithmic_times({1e-3, 1.0}, 20)) test.modulus.push_back({time, test.series.at(time)});
  return test;
}

TEST(IsotropicMean, IsThatOfTheModuliAndOfTheirSeries) {
  const std::vector<TestResult> tests = {relaxing(Load::shear, 2.0), relaxing(Load::bulk, 90.0),
                                         relaxing(Load::diagonal_shear, 4.0)};
  const auto mean = isotropic_mean(2, tests[1].id, tests);
  EXPECT_EQ(mean.id, (TestId{.load = TestLoad::isotropic(), .grid = TestGrid(20)}));
  ASSERT_EQ(mean.modulus.size(), tests[0].modulus.size());
  for (const auto& [time, modulus] : mean.modulus) EXPECT_NEAR(modulus, 1.0 + 3.0 * std::exp(-time / 1e-2), 1e-15);
  EXPECT_EQ(mean.series, PronySeries(1.0, {{1e-2, 3.0}}));
  EXPECT_EQ(mean.error_estimate, 4e-6) << "the larger one";
  EXPECT_TRUE(mean.compliance.empty());
  EXPECT_THAT(std::get<MeanRecord>(mean.record).loads, ElementsAre(Load::shear, Load::diagonal_shear));
}

/// A creep test of a standard linear solid, J = 1 - q exp(-t / 40 ms) 1/Pa, whose modulus is 1 + q / (1 - q) exp(...)
/// Pa.
TestResult creeping(Load load, double q) {
  auto test = relaxing(load, 1.0, 20, Boundary::traction);
  test.series = relaxation_modulus(CreepCompliance(1.0 - q, {{4e-2, q}}));
  for (auto& [time, modulus] : test.modulus) {
    modulus = test.series.at(time);
    test.compliance.push_back({time, 1.0 - q * std::exp(-time / 4e-2)});
  }
  return test;
}

// The compliances add up: with q = 3/4 and 1/4 their mean has q = 1/2.
TEST(IsotropicMean, UnderTractionsIsThatOfTheCompliances) {
  const std::vector<TestResult> tests = {creeping(Load::shear, 0.75), creeping(Load::diagonal_shear, 0.25)};
  const auto mean = isotropic_mean(2, tests[0].id, tests);
  const auto expected = creeping(Load::shear, 0.5);
  ASSERT_EQ(mean.compliance.size(), expected.compliance.size());
  for (std::size_t i = 0; i < mean.modulus.size(); ++i) {
    EXPECT_NEAR(mean.compliance[i].compliance, expected.compliance[i].compliance, 1e-15);
    EXPECT_NEAR(mean.modulus[i].modulus, expected.modulus[i].modulus, 1e-12);
  }
}

TEST(IsotropicMean, NeedsCurvesOfTheSameTimes) {
  std::vector<TestResult> tests = {relaxing(Load::shear, 2.0), relaxing(Load::diagonal_shear, 2.0)};
  tests[1].modulus.pop_back();
  EXPECT_THAT(test::message_of<InputError>([&] { isotropic_mean(2, tests[0].id, tests); }),
              HasSubstr("the curve under shear-xx-yy has other times than that under shear"));
}

TEST(IsotropicMean, OfAnUnknownErrorHasNone) {
  std::vector<TestResult> tests = {relaxing(Load::shear, 2.0), relaxing(Load::diagonal_shear, 4.0)};
  tests[0].error_estimate = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(isotropic_mean(2, tests[0].id, tests).error_estimate));
}

TEST(IsotropicMean, NeedsAllShears) {
  const std::vector<TestResult> tests = {relaxing(Load::shear, 2.0), relaxing(Load::diagonal_shear, 4.0, 40)};
  EXPECT_THAT(test::message_of<InputError>([&] { isotropic_mean(2, tests[0].id, tests); }),
              HasSubstr("isotropic mean: there is no test under shear-xx-yy by displacement, 20 cells, quasi-static"));
}

// The shears change by 10 and -8 %, their mean by 1 %. Grids of half the cells: the band is twice the change.
TEST(IsotropicMean, HasTheLargestBandOfItsShears) {
  std::vector<TestResult> tests = {relaxing(Load::shear, 0.0, 20), relaxing(Load::diagonal_shear, 0.0, 20),
                                   relaxing(Load::shear, 0.0, 40), relaxing(Load::diagonal_shear, 0.0, 40)};
  const auto scale = [](TestResult& test, double factor) {
    for (auto& sample : test.modulus) sample.modulus *= factor;
  };
  scale(tests[0], 1.10);
  scale(tests[1], 0.92);
  for (const int cells : {20, 40}) tests.push_back(isotropic_mean(2, relaxing(Load::shear, 0.0, cells).id, tests));
  const auto limits = extrapolate_tests("A", 1e-3, 2, tests, Mixing::series);
  const auto limit = std::ranges::find(limits, TestLoad::isotropic(), [](const auto& test) { return test.id.load; });
  ASSERT_NE(limit, limits.end());
  EXPECT_NEAR(limit->modulus.front().modulus, 1.0, 1e-15);
  for (const double half_band : limit->half_bands) EXPECT_NEAR(half_band, 0.20, 1e-12);
}

TEST(AnisotropyOfTests, IsTheDistanceOfTheShears) {
  std::vector<TestResult> tests = {relaxing(Load::shear, 2.0), relaxing(Load::diagonal_shear, 4.0)};
  EXPECT_FALSE(anisotropy_of_tests(2, tests)) << "without a mean";
  tests.push_back(isotropic_mean(2, tests[0].id, tests));
  const auto anisotropy = anisotropy_of_tests(2, tests).value();
  EXPECT_EQ(anisotropy.first.time, 1e-3);
  const double relaxed = std::exp(-0.1);
  EXPECT_NEAR(anisotropy.first.distance, (1.0 + 4.0 * relaxed) / (1.0 + 2.0 * relaxed) - 1.0, 1e-12);
  EXPECT_EQ(anisotropy.last.time, 1.0);
  EXPECT_NEAR(anisotropy.last.distance, 0.0, 1e-12);
  for (auto& test : tests) test.modulus.back().modulus = 0.0;
  EXPECT_FALSE(anisotropy_of_tests(2, tests)) << "of nothing";
}

// With points the mean of two limits that change in opposite ways would have nearly no band.
TEST(IsotropicMean, HasTheLargestBandOfItsShearsWithPointsToo) {
  std::vector<TestResult> tests = {relaxing(Load::shear, 0.0, 20), relaxing(Load::diagonal_shear, 0.0, 20),
                                   relaxing(Load::shear, 0.0, 40), relaxing(Load::diagonal_shear, 0.0, 40)};
  for (auto& sample : tests[0].modulus) sample.modulus *= 1.10;
  for (auto& sample : tests[1].modulus) sample.modulus *= 0.92;
  for (const int cells : {20, 40}) tests.push_back(isotropic_mean(2, relaxing(Load::shear, 0.0, cells).id, tests));
  const auto limits = extrapolate_tests("A", 1e-3, 2, tests, Mixing::points);
  const auto& shear = preferred_test(limits, Load::shear, Boundary::displacement);
  const auto& mean = preferred_test(limits, TestLoad::isotropic(), Boundary::displacement);
  EXPECT_NEAR(mean.half_bands[0] / mean.modulus[0].modulus, shear.half_bands[0] / shear.modulus[0].modulus, 1e-12);
}

/// Two stages of a few discs, whose results are means.
Study isotropic_chain() {
  auto study = test::two_stages();
  study.tests.loads = {TestLoad::isotropic()};
  return study;
}

TEST(IsotropicMean, IsTheShearModulusOfAStageAsAMaterial) {
  const auto study = isotropic_chain();
  const auto result = solve(study);
  const auto& tests = result.stages[0].tests;
  for (const auto& [boundary, method, material] : result.stages[0].materials) {
    const auto& mean = preferred_test(tests, TestLoad::isotropic(), boundary);
    const auto& shear = preferred_test(tests, Load::shear, boundary);
    double distance = 0.0;
    for (std::size_t i = 0; i < mean.modulus.size(); ++i) {
      const auto& [time, modulus] = mean.modulus[i];
      EXPECT_NEAR(material.material.shear.at(time) / modulus, 1.0, study.tests.fit_tolerance);
      distance = std::max(distance, std::abs(shear.modulus[i].modulus / modulus - 1.0));
    }
    EXPECT_GT(distance, 2.0 * material.shear_error) << "of the mean, not of one shear";
  }
}

TEST(IsotropicMean, IsAnsweredWithOtherMaterials) {
  const auto study = isotropic_chain();
  const auto result = solve(study);
  const auto answered = responder_of(study, result).respond();
  ASSERT_EQ(answered.size(), result.stages.size());
  for (std::size_t stage = 0; stage < answered.size(); ++stage) {
    for (const auto boundary : study.tests.boundaries) {
      const auto& expected = preferred_test(result.stages[stage].tests, TestLoad::isotropic(), boundary).modulus;
      const auto& found = preferred_test(answered[stage].tests, TestLoad::isotropic(), boundary).modulus;
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].modulus / expected[i].modulus, 1.0, 1e-9);
    }
  }
}

// The modulus at a Laplace variable is that of the mean series, s times its Laplace transform; its derivative is that
// of finite differences.
TEST(IsotropicMean, HasAModulusAndAGradientAtALaplaceVariable) {
  auto study = isotropic_chain();
  study.stages.resize(1);
  const auto result = solve(study);
  const auto responder = responder_of(study, result);
  constexpr double s = 100.0;
  for (const auto boundary : study.tests.boundaries) {
    const auto& series = preferred_test(result.stages[0].tests, TestLoad::isotropic(), boundary).series;
    double expected = series.equilibrium();
    for (const auto& [time, modulus] : series.terms()) expected += modulus * s * time / (1.0 + s * time);
    const auto at = [&](double shear) {
      return responder.modulus_and_gradient(study.stages[0].name, TestLoad::isotropic(), boundary,
                                            {{"binder", {.bulk = 1e9, .shear = shear}}});
    };
    const double shear = 1e4 + 0.5e6 * s * 0.01 / (1.0 + s * 0.01), step = 1e-4 * shear;
    EXPECT_NEAR(at(shear).modulus.real() / expected, 1.0, 1e-6);
    const double difference = (at(shear + step).modulus - at(shear - step).modulus).real() / (2.0 * step);
    EXPECT_NEAR(at(shear).gradient.at("binder").shear.real() / difference, 1.0, 1e-5);
  }
}

}  // namespace
}  // namespace breccia
