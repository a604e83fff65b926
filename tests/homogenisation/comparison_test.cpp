#include "homogenisation/run/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/study/study.hpp"

namespace breccia {
namespace {

using testing::DoubleNear;
using testing::IsEmpty;

const TestId upper{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(12)};

TestResult test_with(const TestId& id, Curve modulus) {
  TestResult test{.id = id};
  test.modulus = std::move(modulus);
  return test;
}

class Compare : public testing::Test {
 protected:
  Compare() {
    stage.name = "A";
    study.tests.boundaries = {Boundary::displacement};
  }
  [[nodiscard]] std::vector<Comparison> compared(const std::vector<TestResult>& tests) const {
    StageFindings found;
    found.name = stage.name;
    found.tests = tests;
    return compare(study.measurements, found, Load::shear);
  }

  Study study;
  Stage stage;
};

// The measured curve goes from 8 Pa at 1 s to 2 Pa at 100 s as a power of time, so that it is 4 Pa at 10 s.
TEST_F(Compare, TellsTheModulusBesideAMeasuredCurve) {
  study.measurements = {{"rheometer", "A", Curve{{1.0, 8.0}, {100.0, 2.0}}}};
  const auto found = compared({test_with(upper, {{0.1, 20.0}, {1.0, 16.0}, {10.0, 12.0}, {100.0, 1.0}, {1e3, 0.5}})});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].measurement, "rheometer");
  EXPECT_EQ(found[0].test, upper);
  ASSERT_EQ(found[0].samples.size(), 3U) << "the times that were measured";
  EXPECT_EQ(found[0].samples[0].time, 1.0);
  EXPECT_THAT(found[0].samples[0].ratio(), DoubleNear(2.0, 1e-12));
  EXPECT_THAT(found[0].samples[1].measured, DoubleNear(4.0, 1e-12));
  EXPECT_EQ(found[0].samples[1].modulus, 12.0);
  EXPECT_THAT(found[0].samples[2].ratio(), DoubleNear(0.5, 1e-12));
  EXPECT_EQ(found[0].best()->time, 1.0) << "twice is as far as half, and comes first";
  EXPECT_EQ(found[0].worst()->time, 10.0);
}

// G = 3 Pa within 2 %, K = 5 Pa within 6 %: E = 9 K G / (3 K + G) = 7.5 Pa, five sixths of whose error are that of G.
TEST_F(Compare, HasTheErrorsOfTheComputedModuli) {
  const auto known = [](Load load, double modulus, double error) {
    auto test =
        test_with({load, Boundary::periodic, Method::quasistatic, TestGrid(12)}, {{1.0, modulus}, {10.0, modulus}});
    test.series = PronySeries(modulus);
    const ModulusError whole{.grid = error, .sample = 0.0, .solver = 0.0, .matrix = 0.0};
    test.errors = {whole, whole};
    return test;
  };
  StageFindings found;
  found.name = stage.name;
  found.dimensions = 3;
  found.tests = {known(Load::shear, 3.0, 0.02), known(Load::bulk, 5.0, 0.06)};
  const auto error_of = [&](ModulusKind kind) {
    Measurement measurement{"rheometer", "A", PronySeries(1.0)};
    measurement.kind = kind;
    return compare({measurement}, found, Load::shear).at(0).samples.at(1).error.value();
  };
  EXPECT_THAT(error_of(ModulusKind::shear), DoubleNear(0.02, 1e-12));
  EXPECT_THAT(error_of(ModulusKind::bulk), DoubleNear(0.06, 1e-12));
  EXPECT_THAT(error_of(ModulusKind::young), DoubleNear((5.0 * 0.02 + 0.06) / 6.0, 1e-12));
  found.tests[1].errors[1].grid = std::nullopt;
  Measurement young{"rheometer", "A", PronySeries(1.0)};
  young.kind = ModulusKind::young;
  const auto samples = compare({young}, found, Load::shear).at(0).samples;
  EXPECT_TRUE(samples.at(0).error);
  EXPECT_FALSE(samples.at(1).error) << "that of the test in bulk is not known";
}

TEST_F(Compare, TakesASeriesWithinTheTimesInWhichItHolds) {
  study.measurements = {{"published", "A", PronySeries(2.0, {{10.0, 4.0}}), TimeWindow{1.0, 10.0}}};
  const auto found = compared({test_with(upper, {{0.1, 20.0}, {1.0, 16.0}, {10.0, 12.0}, {100.0, 1.0}})});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].samples.size(), 2U);
  EXPECT_THAT(found[0].samples[1].measured, DoubleNear(2.0 + 4.0 / std::exp(1.0), 1e-12));
}

TEST_F(Compare, LeavesOutOtherStagesAndOtherTimes) {
  study.measurements = {{"of B", "B", PronySeries(1.0)},
                        {"later", "A", Curve{{100.0, 8.0}, {200.0, 2.0}}},
                        {"between two samples", "A", Curve{{2.0, 8.0}, {3.0, 2.0}}}};
  EXPECT_THAT(compared({test_with(upper, {{1.0, 16.0}, {10.0, 12.0}})}), IsEmpty());
}

TEST_F(Compare, TakesOneTestForEachBoundaryAndMethod) {
  study.tests.boundaries = {Boundary::displacement, Boundary::traction};
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  study.measurements = {{"rheometer", "A", PronySeries(1.0)}};
  std::vector<TestResult> tests;
  for (const auto boundary : study.tests.boundaries) {
    for (const auto method : study.tests.methods) {
      for (const auto grid : {TestGrid::extrapolated(), TestGrid(12)}) {
        tests.push_back(test_with({Load::shear, boundary, method, grid}, {{1.0, 3.0}, {2.0, 3.0}}));
      }
    }
  }
  const auto found = compared(tests);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[3].test, (TestId{Load::shear, Boundary::traction, Method::dynamic, TestGrid::extrapolated()}));
  tests.erase(tests.begin() + 4, tests.end());
  EXPECT_EQ(compared(tests).size(), 2U) << "the traction boundary was not tested";
}

// G' = G x^2 / (1 + x^2) and G'' = G x / (1 + x^2) with x = omega tau; here G is 4 Pa, tau is 1 s.
TEST_F(Compare, TellsTheComplexModulusAtTheMeasuredFrequencies) {
  Measurement measurement{"rheometer", "A", PronySeries(0.0, {{1.0, 4.0}}), TimeWindow{0.01, 2.0}};
  for (const double omega : {0.5, 1.0, 3.0, 100.0, 200.0}) {
    const double x = omega * omega;
    measurement.dynamic.push_back({omega, 2.0 * x / (1.0 + x), 2.0 * omega / (1.0 + x)});
  }
  study.measurements = {measurement};
  auto test = test_with(upper, {{0.02, 4.0}, {1.0, 1.5}, {2.0, 0.5}});
  test.series = PronySeries(0.0, {{1.0, 4.0}});
  const auto found = compared({test});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].in_frequency.size(), 3U) << "1/100 s is before the first time, 1/200 s before the measured ones";
  EXPECT_THAT(found[0].in_frequency[1].storage, DoubleNear(2.0, 1e-12));
  EXPECT_THAT(found[0].in_frequency[1].measured_loss, DoubleNear(1.0, 1e-12));
  EXPECT_THAT(found[0].worst_in_frequency()->ratio(), DoubleNear(2.0, 1e-12));
  EXPECT_THAT(found[0].in_frequency[2].phase_difference(), DoubleNear(0.0, 1e-12));
}

TEST_F(Compare, TakesAMeasuredSeriesAtTheFrequenciesOfTheDeck) {
  study.measurements = {{"published", "A", PronySeries(0.0, {{1.0, 2.0}}), TimeWindow{0.1, 1.0}},
                        {"elastic", "A", PronySeries(2.0)},
                        {"over time", "A", Curve{{0.1, 8.0}, {1.0, 2.0}}}};
  auto test = test_with(upper, {{0.01, 4.0}, {0.1, 3.0}, {1.0, 1.5}});
  test.series = PronySeries(0.0, {{1.0, 4.0}});
  EXPECT_THAT(compared({test})[0].in_frequency, IsEmpty()) << "a deck in times asks for no frequencies";
  test.in_frequency = {{1.0, 2.0, 2.0}, {10.0, 3.96, 0.4}, {100.0, 4.0, 0.04}};
  const auto found = compared({test});
  ASSERT_EQ(found[0].in_frequency.size(), 2U);
  EXPECT_THAT(found[0].best_in_frequency()->ratio(), DoubleNear(2.0, 1e-12));
  EXPECT_THAT(found[1].in_frequency, IsEmpty());
  EXPECT_EQ(found[2].best_in_frequency(), nullptr);
}

// A material whose bulk modulus is three times its shear modulus at all times, G(t) = 1 + 3 exp(-t) Pa: E is 2.7 G, and
// the modulus of the bulk test in the plane is K + G/3 = 10/3 G.
TEST_F(Compare, TakesYoungsAndBulkModulusFromTheTestsInShearAndInBulk) {
  const PronySeries shear(1.0, {{1.0, 3.0}}), in_bulk(10.0 / 3.0, {{1.0, 10.0}});
  Measurement young{"tension", "A", PronySeries(1.0), TimeWindow{0.1, 10.0}, {{1.0, 2.7 * 2.5, 2.7 * 1.5}}};
  young.kind = ModulusKind::young;
  Measurement bulk{"pressure", "A", PronySeries(2.0)};
  bulk.kind = ModulusKind::bulk;
  study.measurements = {young, bulk};
  auto test = test_with(upper, {}),
       volume = test_with({Load::bulk, Boundary::displacement, Method::quasistatic, TestGrid(12)}, {});
  for (const double time : {0.1, 1.0, 10.0}) test.modulus.push_back({time, shear.at(time)});
  test.series = shear;
  volume.series = in_bulk;
  const auto found = compared({test, volume});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, ModulusKind::young);
  ASSERT_EQ(found[0].samples.size(), 3U);
  EXPECT_NEAR(found[0].samples[1].modulus, 2.7 * shear.at(1.0), 1e-8);
  ASSERT_EQ(found[0].in_frequency.size(), 1U);
  EXPECT_NEAR(found[0].in_frequency[0].ratio(), 1.0, 1e-12);
  EXPECT_NEAR(found[0].in_frequency[0].phase_difference(), 0.0, 1e-12);
  EXPECT_EQ(found[1].kind, ModulusKind::bulk);
  EXPECT_NEAR(found[1].samples[2].modulus, 3.0 * shear.at(10.0), 1e-12);
  EXPECT_EQ(measurements_of("A", found)[0].kind, ModulusKind::young);
  EXPECT_THAT(compared({test}), IsEmpty()) << "nothing without the test in bulk";
  volume.id.grid = TestGrid(24);
  EXPECT_THAT(compared({test, volume}), IsEmpty()) << "nothing from tests on two grids";
}

TEST_F(Compare, TakesABulkModulusInSpaceFromTheTestInBulkAlone) {
  Measurement bulk{"pressure", "A", PronySeries(2.0)};
  bulk.kind = ModulusKind::bulk;
  StageFindings found;
  found.name = "A";
  found.dimensions = 3;
  found.tests = {
      test_with({Load::bulk, Boundary::periodic, Method::quasistatic, TestGrid(12)}, {{1.0, 6.0}, {2.0, 5.0}})};
  const auto comparisons = compare({bulk}, found, TestLoad::isotropic());
  ASSERT_EQ(comparisons.size(), 1U);
  EXPECT_EQ(comparisons[0].test.load, Load::bulk);
  EXPECT_EQ(comparisons[0].samples[1].ratio(), 2.5);
}

TEST_F(Compare, TellsMeasurementsFromTheirComparisons) {
  Measurement measurement{"rheometer", "A", Curve{{1.0, 8.0}, {10.0, 4.0}}};
  measurement.dynamic = {{0.5, 2.0, 1.0}};
  study.measurements = {measurement};
  auto test = test_with(upper, {{1.0, 16.0}, {10.0, 12.0}});
  test.series = PronySeries(1.0, {{1.0, 4.0}});
  const auto known = measurements_of("A", compared({test}));
  ASSERT_EQ(known.size(), 1U);
  EXPECT_EQ(known[0].label, "rheometer");
  EXPECT_EQ(known[0].stage, "A");
  EXPECT_THAT(known[0].at(10.0), DoubleNear(4.0, 1e-12));
  ASSERT_EQ(known[0].dynamic.size(), 1U);
  EXPECT_EQ(known[0].dynamic[0].loss, 1.0);
}

TEST(PreferredTest, IsOfTheLimitOrTheFinestGrid) {
  std::vector<TestResult> tests = {
      test_with(upper, {}), test_with({Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(24)}, {}),
      test_with({Load::shear, Boundary::displacement, Method::dynamic, TestGrid(48)}, {})};
  EXPECT_EQ(preferred_test(tests, Load::shear, Boundary::displacement).id.grid, TestGrid(24));
  EXPECT_EQ(preferred_test(tests, Load::shear, Boundary::displacement, Method::dynamic).id.grid, TestGrid(48));
  tests.push_back(test_with({.grid = TestGrid::extrapolated()}, {}));
  EXPECT_TRUE(preferred_test(tests, Load::shear, Boundary::displacement).id.grid.is_extrapolated());
  EXPECT_EQ(find_preferred_test(tests, Load::bulk, Boundary::displacement), nullptr);
  EXPECT_EQ(find_preferred_test(tests, Load::shear, Boundary::traction), nullptr);
  EXPECT_THROW(static_cast<void>(preferred_test(tests, Load::shear, Boundary::periodic)), InputError);
}

}  // namespace
}  // namespace breccia
