#include "breccia/virtual_test/curve.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(LogarithmicTimes, HoldTheEndsAndTheDecadesBetween) {
  EXPECT_THAT(logarithmic_times({2.0, 300.0}, 1),
              ElementsAre(2.0, DoubleNear(10.0, 1e-12), DoubleNear(100.0, 1e-12), 300.0));
  EXPECT_THAT(logarithmic_times({10.0, 100.0}, 2), ElementsAre(10.0, DoubleNear(std::sqrt(1000.0), 1e-12), 100.0));
  EXPECT_THAT(logarithmic_times({3.0, 3.0}, 20), ElementsAre(3.0));
}

template <class Function>
Curve sampled(Function&& function, double from, double to, double ratio) {
  Curve curve;
  for (double t = from; t <= to; t *= ratio) curve.push_back({t, function(t)});
  return curve;
}

TEST(SmoothedAt, IsExactForParabolasInLogTime) {
  const auto parabola = [](double t) { return 3.0 - std::log(t) + 0.2 * std::log(t) * std::log(t); };
  const auto curve = sampled(parabola, 0.1, 100.0, 1.005);
  for (const double t : {0.2, 1.0, 7.0, 90.0}) EXPECT_NEAR(smoothed_at(curve, t), parabola(t), 1e-10);
}

TEST(SmoothedAt, HardlyBiasesASteepRelaxation) {
  const auto exponential = [](double t) { return std::exp(-t); };
  const auto curve = sampled(exponential, 0.1, 10.0, 1.005);
  for (const double t : {0.5, 1.0, 5.0}) EXPECT_NEAR(smoothed_at(curve, t) / exponential(t), 1.0, 1e-4);
}

TEST(SmoothedAt, AveragesShortRinging) {
  const auto ringing = [](double t) { return 1.0 + 0.1 * std::sin(2.0 * std::numbers::pi * 20.0 * t); };
  const auto curve = sampled(ringing, 0.1, 10.0, 1.0005);
  EXPECT_NEAR(smoothed_at(curve, 5.0), 1.0, 0.01);
}

TEST(SmoothedAt, InterpolatesWhereSamplesAreFew) {
  EXPECT_DOUBLE_EQ(smoothed_at(Curve{{1.0, 4.0}, {100.0, 2.0}}, 10.0), 3.0);
  EXPECT_DOUBLE_EQ(smoothed_at(Curve{{1.0, 4.0}, {100.0, 2.0}}, 1.0), 4.0);
}

TEST(SmoothedAt, KnowsTheOnlySample) {
  EXPECT_EQ(smoothed_at(Curve{{2.0, 4.0}}, 2.0), 4.0);
  EXPECT_THROW((void)smoothed_at(Curve{{2.0, 4.0}}, 2.5), InputError);
}

TEST(SmoothedAt, RefusesToExtrapolate) {
  const Curve curve = {{1.0, 4.0}, {100.0, 2.0}};
  EXPECT_THROW((void)smoothed_at(curve, 0.5), InputError);
  EXPECT_THROW((void)smoothed_at(curve, 101.0), InputError);
  EXPECT_THROW((void)smoothed_at(Curve{}, 1.0), InputError);
}

TEST(LogarithmicTimes, AreAtLeastOneADecade) {
  for (const int per_decade : {0, -3}) {
    EXPECT_THROW(static_cast<void>(logarithmic_times({1.0, 10.0}, per_decade)), InputError) << per_decade;
  }
}

}  // namespace
}  // namespace breccia
