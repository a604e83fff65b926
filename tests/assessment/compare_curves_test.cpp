#include "breccia/assessment/compare_curves.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// G = amount / t, which is straight on logarithmic axes, with one error at all times.
SampledCurve falling(std::vector<double> times, double amount, std::optional<double> error) {
  SampledCurve curve = {.name = "G", .unit = "Pa", .at = std::move(times)};
  curve.values = Eigen::MatrixXd(std::ssize(curve.at), 1);
  for (std::size_t i = 0; i < curve.at.size(); ++i)
    curve.values(static_cast<Eigen::Index>(i), 0) = amount / curve.at[i];
  curve.errors.assign(curve.at.size(), error);
  return curve;
}

TEST(CompareCurves, TakesTheTimesOfTheFirstAndTheEndsOfWhatAllHave) {
  const auto compared =
      compare_curves({{falling({0.1, 1.0, 10.0, 100.0}, 1e6, 0.03)}, {falling({0.5, 5.0, 50.0}, 1.1e6, 0.04)}});
  ASSERT_THAT(compared.curves, SizeIs(1));
  const auto& curve = compared.curves.front();
  EXPECT_THAT(curve.at, ElementsAre(0.5, 1.0, 10.0, 50.0));
  for (std::size_t i = 0; i < 4; ++i) {
    const auto difference = difference_from_first(curve, 1, i);
    EXPECT_NEAR(difference.value, 1.1, 1e-12) << "between the times of the second";
    ASSERT_TRUE(difference.error);
    EXPECT_NEAR(*difference.error, 0.05, 1e-12);
    EXPECT_TRUE(difference.is_beyond_error());
  }
  EXPECT_DOUBLE_EQ(difference_from_first(curve, 0, 0).value, 1.0);
  EXPECT_THAT(compared.left_out, SizeIs(0));
}

TEST(CompareCurves, ADifferenceWithinTheErrorsIsNone) {
  const auto known = compare_curves({{falling({1.0, 2.0}, 1e6, 0.03)}, {falling({1.0, 2.0}, 1.04e6, 0.04)}});
  EXPECT_FALSE(difference_from_first(known.curves.front(), 1, 0).is_beyond_error());
  const auto unknown = compare_curves({{falling({1.0, 2.0}, 1e6, {})}, {falling({1.0, 2.0}, 2e6, 0.04)}});
  EXPECT_FALSE(difference_from_first(unknown.curves.front(), 1, 0).error);
  EXPECT_FALSE(difference_from_first(unknown.curves.front(), 1, 0).is_beyond_error()) << "nobody knows";
}

TEST(CompareCurves, ComparesPhasesByDifferences) {
  std::vector<std::vector<SampledCurve>> composites;
  for (const double phase : {0.2, 0.25}) {
    SampledCurve curve = {.name = "phase of G*", .unit = "rad", .curve = ObservedCurve::phase, .at = {1.0, 10.0}};
    curve.values = Eigen::MatrixXd::Constant(2, 1, phase);
    curve.errors.resize(2);
    composites.push_back({curve});
  }
  EXPECT_NEAR(difference_from_first(compare_curves(composites).curves.front(), 1, 0).value, 0.05, 1e-12);
}

TEST(CompareCurves, LeavesOutWhatNotAllHave) {
  auto bulk = falling({1.0, 2.0}, 1e9, 0.03);
  bulk.name = "K";
  bulk.modulus = ObservedModulus::bulk;
  const auto compared = compare_curves({{falling({1.0, 2.0}, 1e6, 0.03)}, {falling({1.0, 2.0}, 1e6, 0.03), bulk}});
  EXPECT_THAT(compared.curves, SizeIs(1));
  EXPECT_THAT(compared.left_out, ElementsAre("K"));
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(compare_curves({{falling({1.0, 2.0}, 1e6, 0.03)}, {bulk}}));
              }),
              HasSubstr("no curve in common; they have, in their order: G; K"));
  EXPECT_THAT(test::message_of<InputError>([&] {
                static_cast<void>(compare_curves({{falling({1.0, 2.0}, 1e6, 0.03)}, {falling({3.0, 4.0}, 1e6, 0.03)}}));
              }),
              HasSubstr("share no time"));
}

TEST(CompareCurves, SaysHowFarMeasuredValuesAre) {
  const std::vector<SampledCurve> curves = {falling({0.1, 1.0, 10.0}, 1e6, 0.03)};
  const auto measured = [](double at, double ratio) {
    return Observation{.curve = ObservedCurve::relaxation, .at = at, .value = 1e6 / at / ratio};
  };
  const auto deviation = deviation_from({measured(0.2, 1.1), measured(2.0, 0.8)}, curves);
  EXPECT_EQ(deviation.count, 2U);
  EXPECT_NEAR(deviation.rms, std::sqrt(0.5 * (std::pow(std::log(1.1), 2) + std::pow(std::log(0.8), 2))), 1e-12);
  EXPECT_NEAR(deviation.least, 0.8, 1e-12);
  EXPECT_NEAR(deviation.most, 1.1, 1e-12);
  EXPECT_DOUBLE_EQ(deviation.at_least, 2.0);
  EXPECT_DOUBLE_EQ(deviation.at_most, 0.2);
}

TEST(CompareCurves, TakesStorageAndLossAsOneValue) {
  SampledCurve absolute = {.name = "|G*|", .unit = "Pa", .curve = ObservedCurve::absolute, .at = {1.0, 10.0}};
  absolute.values = Eigen::MatrixXd::Constant(2, 1, 1e6);
  const auto values = comparable_values({{.curve = ObservedCurve::storage, .at = 3.0, .value = 3e5},
                                         {.curve = ObservedCurve::loss, .at = 3.0, .value = 4e5}},
                                        {absolute});
  ASSERT_THAT(values, SizeIs(1));
  EXPECT_EQ(values.front().curve, ObservedCurve::absolute);
  EXPECT_NEAR(values.front().value, 5e5, 1e-6);
  const std::vector<SampledCurve> in_time = {falling({0.1, 10.0}, 1e6, 0.03)};
  EXPECT_THAT(
      test::message_of<InputError>([&] {
        static_cast<void>(comparable_values({{.curve = ObservedCurve::creep, .at = 100.0, .value = 1e-6}}, in_time));
      }),
      HasSubstr("shear modulus (creep)"))
      << "the kind comes before the times";
}

}  // namespace
}  // namespace breccia
