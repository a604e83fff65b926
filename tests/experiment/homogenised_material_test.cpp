#include "breccia/experiment/homogenised_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const PronySeries shear(2e5, {{1e-1, 3e6}, {1e-4, 8e7}});
const PronySeries bulk(4e9, {{1e-3, 5e8}});

/// K + G/3, or G alone, at logarithmic times.
Curve curve_of(double bulk_share, double shear_share, const TimeWindow& window) {
  Curve curve;
  for (const double t : logarithmic_times(window, 20)) {
    curve.push_back({t, bulk_share * bulk.at(t) + shear_share * shear.at(t)});
  }
  return curve;
}

TEST(HomogenisedMaterial, TakesTheBulkModulusOutOfThePlaneStrainOne) {
  const TimeWindow window = {1e-6, 1.0};
  const auto found =
      homogenised_material("stage", 1700.0, curve_of(0.0, 1.0, window), curve_of(1.0, 1.0 / 3.0, window));
  EXPECT_EQ(found.material.name, "stage");
  EXPECT_EQ(found.material.density, 1700.0);
  EXPECT_DOUBLE_EQ(found.fitted.begin, window.begin);
  EXPECT_DOUBLE_EQ(found.fitted.end, window.end);
  // Neither time is among those that a fit chooses from.
  constexpr double tolerance = 5e-3;
  EXPECT_LT(found.shear_error, tolerance);
  EXPECT_LT(found.bulk_error, tolerance);
  for (const double t : logarithmic_times({2e-6, 0.5}, 7)) {
    EXPECT_NEAR(found.material.shear.at(t) / shear.at(t), 1.0, 1.1 * found.shear_error) << t;
    EXPECT_NEAR(found.material.bulk.at(t) / bulk.at(t), 1.0, 1.1 * (found.bulk_error + found.shear_error)) << t;
  }
}

TEST(HomogenisedMaterial, UsesTheTimesThatBothCurvesHave) {
  const auto later = curve_of(1.0, 1.0 / 3.0, {1e-4, 1.0});
  const auto found = homogenised_material("stage", 1.0, curve_of(0.0, 1.0, {1e-6, 1e-1}), later);
  EXPECT_DOUBLE_EQ(found.fitted.begin, 1e-4);
  EXPECT_DOUBLE_EQ(found.fitted.end, 1e-1);
}

TEST(HomogenisedMaterial, RefusesCurvesThatHaveNoTimesInCommon) {
  EXPECT_THAT(
      [] {
        homogenised_material("S", 1.0, {{1.0, 2.0}, {2.0, 1.0}}, {{3.0, 9.0}, {4.0, 9.0}});
      },
      ThrowsMessage<NumericalError>(HasSubstr("0 times in common")));
}

TEST(HomogenisedMaterial, LetsTheBulkModulusRise) {
  // K + G/3 that does not relax beside G that does.
  const TimeWindow window = {1e-6, 1.0};
  Curve constant;
  for (const double t : logarithmic_times(window, 20)) constant.push_back({t, 4e9});
  const auto found = homogenised_material("S", 1.0, curve_of(0.0, 1.0, window), constant);
  for (const double t : {1e-6, 1e-3, 1.0}) {
    EXPECT_NEAR(found.material.bulk.at(t) / (4e9 - shear.at(t) / 3.0), 1.0, 1e-3) << t;
  }
}

}  // namespace
}  // namespace breccia
