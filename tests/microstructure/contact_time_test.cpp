#include "microstructure/contact_time.hpp"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace breccia {
namespace {

using Plane = std::array<double, 2>;

TEST(ContactTime, HeadOnOfTwoDiscsOfConstantSize) {
  // centres 5 apart, radii together 2, closing at 1.5
  EXPECT_DOUBLE_EQ(contact_time(Plane{5.0, 0.0}, Plane{-1.5, 0.0}, 2.0, 0.0), 2.0);
}

TEST(ContactTime, DiscsAtRestMeetByGrowth) {
  EXPECT_DOUBLE_EQ(contact_time(Plane{3.0, 4.0}, Plane{0.0, 0.0}, 2.0, 0.25), 12.0);
}

TEST(ContactTime, GrowthAddsToTheClosingSpeed) {
  EXPECT_DOUBLE_EQ(contact_time(Plane{5.0, 0.0}, Plane{-1.0, 0.0}, 2.0, 0.5), 2.0);
}

TEST(ContactTime, FastGrowthCatchesDiscsThatFlyApart) {
  EXPECT_DOUBLE_EQ(contact_time(Plane{5.0, 0.0}, Plane{1.0, 0.0}, 2.0, 2.0), 3.0);
}

TEST(ContactTime, OffCentreHitOfAThreeFourFiveTriangle) {
  // moving along x with offset 3 they touch where the distance along x is 4
  EXPECT_DOUBLE_EQ(contact_time(Plane{10.0, 3.0}, Plane{-2.0, 0.0}, 5.0, 0.0), 3.0);
}

TEST(ContactTime, NeverIfTheyPassOrSeparate) {
  EXPECT_EQ(contact_time(Plane{10.0, 5.001}, Plane{-2.0, 0.0}, 5.0, 0.0), never);
  EXPECT_EQ(contact_time(Plane{5.0, 0.0}, Plane{1.0, 0.0}, 2.0, 0.5), never);
  EXPECT_EQ(contact_time(Plane{5.0, 0.0}, Plane{0.0, 0.0}, 2.0, 0.0), never);
}

TEST(ContactTime, OverlapByRoundoffIsAContactOnlyIfTheyApproach) {
  EXPECT_EQ(contact_time(Plane{2.0 - 1e-15, 0.0}, Plane{-1.0, 0.0}, 2.0, 0.0), 0.0);
  EXPECT_EQ(contact_time(Plane{2.0 - 1e-15, 0.0}, Plane{1.0, 0.0}, 2.0, 0.0), never);
}

TEST(ContactTime, SmallGapsKeepTheirDigits) {
  const double gap = 1e-9;
  EXPECT_NEAR(contact_time(Plane{2.0 + gap, 0.0}, Plane{-1.0, 0.0}, 2.0, 0.0), gap, 1e-15);
}

TEST(ContactTime, DistanceIsThatOfContactForRandomDiscsInSpace) {
  std::mt19937_64 engine(7);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0; };
  int contacts = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const std::array<double, 3> r = {4.0 + uniform(), uniform(), uniform()};
    const std::array<double, 3> v = {uniform(), uniform(), uniform()};
    const double rate = 0.3 * (1.0 + uniform());
    const double t = contact_time(r, v, 1.0, rate);
    if (t == never) continue;
    ++contacts;
    EXPECT_NEAR(norm(r + t * v), 1.0 + rate * t, 1e-12 * (1.0 + t));
  }
  EXPECT_GT(contacts, 50);
}

TEST(LeaveTime, FromTheCentreAndFromAside) {
  EXPECT_DOUBLE_EQ(leave_time(Plane{0.0, 0.0}, Plane{3.0, 4.0}, 2.0), 0.4);
  EXPECT_DOUBLE_EQ(leave_time(Plane{0.0, 3.0}, Plane{2.0, 0.0}, 5.0), 2.0);
  EXPECT_EQ(leave_time(Plane{0.0, 0.0}, Plane{0.0, 0.0}, 2.0), never);
}

TEST(LeaveTime, OnTheSurface) {
  EXPECT_EQ(leave_time(Plane{2.0, 0.0}, Plane{1.0, 0.0}, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(leave_time(Plane{2.0, 0.0}, Plane{-1.0, 0.0}, 2.0), 4.0);
}

}  // namespace
}  // namespace breccia
