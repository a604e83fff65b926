#include "homogenisation/run/stage_extrapolation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "one_vector_response.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The limits of tests in a box of 1 mm.
std::vector<TestResult> limits_of(const std::vector<TestResult>& tests, Mixing mixing) {
  return extrapolate_tests("A", 1e-3, 2, tests, mixing);
}

/// A test with a constant modulus.
TestResult constant(int cells, double modulus, Boundary boundary = Boundary::displacement) {
  TestResult test{.id = {.boundary = boundary, .grid = TestGrid(cells)}};
  for (const double time : logarithmic_times({1e-2, 1.0}, 5)) test.modulus.push_back({time, modulus});
  return test;
}

std::vector<int> grids_of(const TestResult& test) {
  return std::get<ExtrapolationRecord>(test.record).cells;
}

// The modulus 10 + 40 h / L on two grids is 14 and 12; the band of two grids is half of the correction of the finest
// grid.
TEST(ExtrapolateTests, TakesTheLimitOfTwoGrids) {
  const auto limits = limits_of({constant(10, 14.0), constant(20, 12.0)}, Mixing::points);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0].id, (TestId{.grid = TestGrid::extrapolated()}));
  ASSERT_EQ(limits[0].modulus.size(), 11U);
  for (const auto& sample : limits[0].modulus) EXPECT_THAT(sample.modulus, DoubleNear(10.0, 1e-12));
  EXPECT_THAT(grids_of(limits[0]), ElementsAre(10, 20));
  EXPECT_THAT(limits[0].half_bands, Each(DoubleNear(1.0, 1e-12)));
  EXPECT_NEAR(limits[0].series.at(0.1), 10.0, 1e-6);
  EXPECT_THAT(limits[0].compliance, IsEmpty());
}

// The moduli are 18, 14 and 11: the two finest grids give the limit 8, the two coarsest 10.
TEST(ExtrapolateTests, TakesTheBandFromThreeGrids) {
  const auto limits = limits_of({constant(10, 18.0), constant(20, 14.0), constant(40, 11.0)}, Mixing::points);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_THAT(limits[0].modulus.front().modulus, DoubleNear(8.0, 1e-12));
  EXPECT_THAT(grids_of(limits[0]), ElementsAre(10, 20, 40));
  EXPECT_THAT(limits[0].half_bands, Each(DoubleNear(2.0, 1e-12)));
}

TEST(ExtrapolateTests, TakesCompliancesByThemselves) {
  auto coarse = constant(10, 1.0, Boundary::traction), fine = constant(20, 1.0, Boundary::traction);
  for (const auto& [time, modulus] : coarse.modulus) {
    coarse.compliance.push_back({time, 0.2});
    fine.compliance.push_back({time, 0.5});
  }
  const auto limits = limits_of({coarse, fine}, Mixing::points);
  ASSERT_EQ(limits.size(), 1U);
  ASSERT_EQ(limits[0].compliance.size(), 11U);
  EXPECT_THAT(limits[0].compliance.front().compliance, DoubleNear(0.8, 1e-12));
  EXPECT_EQ(limits[0].compliance.back().time, 1.0);
}

TEST(ExtrapolateTests, KeepsTestsApart) {
  const auto limits = limits_of({constant(10, 14.0), constant(10, 7.0, Boundary::traction), constant(20, 12.0),
                                 constant(20, 6.0, Boundary::traction)},
                                Mixing::points);
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_THAT(limits[0].modulus.front().modulus, DoubleNear(10.0, 1e-12));
  EXPECT_EQ(limits[1].id.boundary, Boundary::traction);
  EXPECT_THAT(limits[1].modulus.front().modulus, DoubleNear(5.0, 1e-12));
}

// With mixed cells the coarse modulus 15 differs from 12 by a quarter, and at the last time 9 differs from 6 by a half.
TEST(ExtrapolateTests, TakesTheFinestGridOfMixedCells) {
  auto coarse = constant(20, 15.0), fine = constant(40, 12.0);
  coarse.modulus.back().modulus = 9.0;
  fine.modulus.back().modulus = 6.0;
  fine.compliance = {{1.0, 0.2}};
  fine.series = PronySeries(3.0);
  const auto limits = limits_of({constant(10, 99.0), coarse, fine}, Mixing::series);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0].id, (TestId{.grid = TestGrid::extrapolated()}));
  EXPECT_EQ(limits[0].modulus, fine.modulus);
  EXPECT_EQ(limits[0].compliance, fine.compliance);
  EXPECT_EQ(limits[0].series, fine.series);
  EXPECT_THAT(grids_of(limits[0]), ElementsAre(10, 20, 40));
  EXPECT_THAT(limits[0].half_bands.front(), DoubleNear(0.5 * 12.0, 1e-12));
  EXPECT_THAT(limits[0].half_bands.back(), DoubleNear(1.0 * 6.0, 1e-12));
}

// The bulk test changes by 1 %, a shear beside it by 10 %: by more than twice as much.
TEST(ExtrapolateTests, TheBandOfABulkTestIsNoLessThanTheChangeOfAShearBesideIt) {
  auto coarse = constant(20, 10.1), fine = constant(40, 10.0);
  coarse.id.load = fine.id.load = Load::bulk;
  const auto alone = limits_of({coarse, fine}, Mixing::series);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_THAT(alone[0].half_bands, Each(DoubleNear(0.4, 1e-12))) << "twice as wide as of a shear";
  const auto beside = limits_of({constant(20, 5.5), coarse, constant(40, 5.0), fine}, Mixing::series);
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_THAT(beside[0].half_bands, Each(DoubleNear(1.0, 1e-12))) << "of the shear";
  EXPECT_THAT(beside[1].half_bands, Each(DoubleNear(1.0, 1e-12))) << "of the bulk test";
}

// From 30 to 40 cells an error of first order falls by a quarter: the change of 2 is a third of what is left.
TEST(ExtrapolateTests, GridsOfNearlyAsManyCellsHaveAWideBand) {
  const auto limits = limits_of({constant(30, 22.0), constant(40, 20.0)}, Mixing::series);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_THAT(limits[0].half_bands, Each(DoubleNear(2.0 * 3.0 * 2.0, 1e-12)));
}

// Two grids do not show the error of the model of flow between spheres.
TEST(ExtrapolateTests, TheBandOfFlowInSpaceIsNoLessThanItsLargestError) {
  const std::vector tests{constant(20, 10.1), constant(40, 10.0)};
  const auto in_space = extrapolate_tests("A", 1e-3, 3, tests, Mixing::flow);
  ASSERT_EQ(in_space.size(), 1U);
  EXPECT_THAT(in_space[0].half_bands, Each(DoubleNear(1.4, 1e-12)));
  EXPECT_THAT(limits_of(tests, Mixing::flow).front().half_bands, Each(DoubleNear(0.2, 1e-12))) << "in the plane";
}

TEST(ExtrapolateTests, IsOfSeveralGridsAlone) {
  EXPECT_THAT(limits_of({constant(20, 12.0)}, Mixing::points), IsEmpty());
}

// The moduli 30 and 10 have the limit -10.
TEST(ExtrapolateTests, RefusesALimitThatIsNoModulus) {
  const auto message = test::message_of<NumericalError>([] {
    static_cast<void>(limits_of({constant(10, 30.0), constant(20, 10.0)}, Mixing::points));
  });
  EXPECT_THAT(message,
              AllOf(HasSubstr("A shear displacement quasistatic: extrapolation to vanishing cells gives -10 Pa "
                              "at 10 ms"),
                    HasSubstr("take finer ones")));
  auto coarse = constant(10, 1.0, Boundary::traction), fine = constant(20, 1.0, Boundary::traction);
  for (const auto& [time, modulus] : coarse.modulus) {
    coarse.compliance.push_back({time, 0.9});
    fine.compliance.push_back({time, 0.4});
  }
  const auto of_compliance = test::message_of<NumericalError>([&] {
    static_cast<void>(limits_of({coarse, fine}, Mixing::points));
  });
  EXPECT_THAT(of_compliance, HasSubstr("extrapolation to vanishing cells gives -0.1 1/Pa at 10 ms"));
}

/// A test of the reduced solver, whose series gives the modulus at all times.
TestResult with_series(int cells, const PronySeries& series) {
  auto test = constant(cells, 1.0);
  test.series = series;
  QuasistaticRecord record;
  record.reduced = test::one_vector_response(Load::shear, Boundary::displacement, {}, {});
  test.record = std::move(record);
  return test;
}

TEST(CurveAt, FollowsASeriesBeyondTheCurve) {
  const PronySeries series(2.0, {{1.0, 4.0}});
  const auto test = with_series(20, series);
  const auto curve = curve_at(test, 1e-3, 2, {test}, Mixing::points, {1e-5, 100.0});
  EXPECT_EQ(curve, (Curve{{1e-5, series.at(1e-5)}, {100.0, series.at(100.0)}}));
}

TEST(CurveAt, FollowsTheLimitOfTheSeriesOfAllGrids) {
  const std::vector tests = {with_series(10, PronySeries(14.0)), with_series(20, PronySeries(12.0))};
  TestResult limit{.id = {.grid = TestGrid::extrapolated()}};
  limit.modulus = {{1.0, 1.0}};
  const auto curve = curve_at(limit, 1e-3, 2, tests, Mixing::points, {1e-5});
  ASSERT_EQ(curve.size(), 1U);
  EXPECT_EQ(curve[0].time, 1e-5);
  EXPECT_THAT(curve[0].modulus, DoubleNear(10.0, 1e-12));
}

TEST(CurveAt, FollowsTheSeriesOfTheFinestGridOfMixedCells) {
  const std::vector tests = {with_series(10, PronySeries(14.0)), with_series(20, PronySeries(12.0))};
  TestResult limit{.id = {.grid = TestGrid::extrapolated()}};
  limit.modulus = {{1.0, 1.0}};
  EXPECT_EQ(curve_at(limit, 1e-3, 2, tests, Mixing::series, {1e-5}), (Curve{{1e-5, 12.0}}));
}

// A series that was fitted to a curve is not valid beyond the curve.
TEST(CurveAt, KeepsToTheCurveWhereASeriesIsAFit) {
  auto test = constant(20, 3.0);
  test.series = PronySeries(5.0);
  EXPECT_EQ(curve_at(test, 1e-3, 2, {test}, Mixing::points, {1e-5, 100.0}), test.modulus);
}

}  // namespace
}  // namespace breccia
