#include "breccia/virtual_test/homogenised_material.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double tolerance = 0.03;

const PronySeries shear(2e5, {{1e-1, 3e6}, {1e-4, 8e7}});
const PronySeries bulk(4e9, {{1e-3, 5e8}});

/// The curve of K + G/3, or of G alone, at logarithmic times.
Curve curve_of(double bulk_share, double shear_share, const TimeWindow& window) {
  Curve curve;
  for (const double t : logarithmic_times(window, 20)) {
    curve.push_back({t, bulk_share * bulk.at(t) + shear_share * shear.at(t)});
  }
  return curve;
}

TEST(HomogenisedMaterial, ComputesTheBulkModulusFromThatInPlaneStrain) {
  const TimeWindow window = {1e-6, 1.0};
  const auto found =
      homogenised_material("stage", 1700.0, curve_of(0.0, 1.0, window), curve_of(1.0, 1.0 / 3.0, window), tolerance);
  EXPECT_EQ(found.material.name, "stage");
  EXPECT_EQ(found.material.density, 1700.0);
  EXPECT_DOUBLE_EQ(found.fitted.begin, window.begin);
  EXPECT_DOUBLE_EQ(found.fitted.end, window.end);
  // Neither relaxation time is among the candidates of a fit.
  EXPECT_LT(found.shear_error, 0.2 * tolerance);
  EXPECT_LT(found.bulk_error, 0.2 * tolerance);
  for (const double t : logarithmic_times({2e-6, 0.5}, 7)) {
    EXPECT_NEAR(found.material.shear.at(t) / shear.at(t), 1.0, 1.1 * found.shear_error) << t;
    EXPECT_NEAR(found.material.bulk.at(t) / bulk.at(t), 1.0, 1.1 * (found.bulk_error + found.shear_error)) << t;
  }
}

TEST(HomogenisedMaterial, UsesTheTimesThatBothCurvesHave) {
  const auto later = curve_of(1.0, 1.0 / 3.0, {1e-4, 1.0});
  const auto found = homogenised_material("stage", 1.0, curve_of(0.0, 1.0, {1e-6, 1e-1}), later, tolerance);
  EXPECT_DOUBLE_EQ(found.fitted.begin, 1e-4);
  EXPECT_DOUBLE_EQ(found.fitted.end, 1e-1);
}

TEST(HomogenisedMaterial, RefusesCurvesThatHaveNoTimesInCommon) {
  EXPECT_THAT(
      [] {
        homogenised_material("S", 1.0, {{1.0, 2.0}, {2.0, 1.0}}, {{3.0, 9.0}, {4.0, 9.0}}, tolerance);
      },
      ThrowsMessage<NumericalError>(HasSubstr("0 times in common")));
}

TEST(HomogenisedMaterial, LetsTheBulkModulusRise) {
  // The modulus K + G/3 does not relax, while G does.
  const TimeWindow window = {1e-6, 1.0};
  Curve constant;
  for (const double t : logarithmic_times(window, 20)) constant.push_back({t, 4e9});
  const auto found = homogenised_material("S", 1.0, curve_of(0.0, 1.0, window), constant, tolerance);
  for (const double t : {1e-6, 1e-3, 1.0}) {
    EXPECT_NEAR(found.material.bulk.at(t) / (4e9 - shear.at(t) / 3.0), 1.0, 1e-3) << t;
  }
}

/// G(t) and K(t) + G(t)/3 of a solid whose spectrum is flat over eleven decades: a term at each half decade.
class BroadSpectrum : public testing::Test {
 protected:
  static PronySeries series(double equilibrium, double strength) {
    std::vector<MaxwellTerm> terms;
    for (int half = -20; half <= 2; ++half) terms.push_back({1.3 * std::pow(10.0, 0.5 * half), strength});
    return {equilibrium, terms};
  }
  static Curve curve(const PronySeries& series) {
    Curve samples;
    for (const double t : logarithmic_times(window, 20)) samples.push_back({t, series.at(t)});
    return samples;
  }
  static HomogenisedMaterial material(double fit_tolerance) {
    return homogenised_material("stage", 1700.0, curve(exact_shear), curve(exact_bulk), fit_tolerance);
  }

  static constexpr TimeWindow window = {1e-9, 1.0};
  static constexpr double decades = 9.0;
  inline static const PronySeries exact_shear = series(3e6, 1e8), exact_bulk = series(9e9, 4e7);
};

TEST_F(BroadSpectrum, TakesNoMoreTermsThanTheToleranceNeeds) {
  const auto found = material(tolerance);
  EXPECT_LE(found.shear_error, 0.034 * tolerance);
  EXPECT_LE(found.bulk_error, 0.034 * tolerance);
  // The times are between those of the samples.
  for (const double t : logarithmic_times(window, 37)) {
    EXPECT_NEAR(found.material.shear.at(t) / exact_shear.at(t), 1.0, 0.037 * tolerance) << t;
  }
  // Shear and bulk have their terms at the same times, at most three a decade.
  EXPECT_LE(found.material.bulk.terms().size(), static_cast<std::size_t>(3.0 * (decades + 1.0)));
  EXPECT_LE(found.material.shear.terms().size(), found.material.bulk.terms().size());
}

TEST_F(BroadSpectrum, TakesMoreTermsForATighterTolerance) {
  const auto rough = material(tolerance), fine = material(0.1 * tolerance);
  EXPECT_LT(rough.material.bulk.terms().size(), fine.material.bulk.terms().size());
  EXPECT_LE(fine.shear_error, 0.0034 * tolerance);
}

TEST_F(BroadSpectrum, FitsAsWellAsItCanWhereNoFitMeetsTheTolerance) {
  constexpr double hopeless = 1e-14;
  const auto best = material(hopeless);
  EXPECT_GT(best.shear_error, hopeless);
  EXPECT_LT(best.shear_error, 1e-4);
}

}  // namespace
}  // namespace breccia
