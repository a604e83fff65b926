#include "microstructure/level_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

constexpr double side = 3.0;

struct RandomBalls {
  std::vector<double> radii;
  std::vector<Vector<2>> centres;
};

/// Radii from 0.001 to 0.5.
RandomBalls random_balls(int count) {
  std::mt19937_64 engine(11);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  RandomBalls balls;
  for (int k = 0; k < count; ++k) {
    balls.radii.push_back(0.5 * std::pow(500.0, -uniform()));
    balls.centres.push_back({side * uniform(), side * uniform()});
  }
  return balls;
}

class LevelGridTest : public ::testing::TestWithParam<Walls> {};

TEST_P(LevelGridTest, FindsEveryBallInReach) {
  const auto [radii, centres] = random_balls(300);
  const PeriodicImages<2> images(side);
  LevelGrid<2> grid(side, GetParam(), radii);
  for (std::uint32_t ball = 0; ball < radii.size(); ++ball) grid.insert(ball, centres[ball]);
  for (std::uint32_t ball = 0; ball < radii.size(); ball += 3) grid.remove(ball);

  for (std::uint32_t ball = 0; ball < radii.size(); ++ball) {
    const double reach = radii[ball];
    std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
    grid.visit_near(centres[ball], reach, [&](std::uint32_t other, std::uint32_t image) {
      EXPECT_TRUE(visited.emplace(other, image).second) << "visited twice";
      EXPECT_NE(other % 3, 0U) << "was removed";
    });
    for (std::uint32_t other = 0; other < radii.size(); ++other) {
      for (std::uint32_t image = 0; image < PeriodicImages<2>::count; ++image) {
        if (other % 3 == 0 || (GetParam() == Walls::hard && image != PeriodicImages<2>::in_place)) continue;
        const auto seen = centres[other] + images.shift(image);
        if (norm(seen - centres[ball]) >= reach + radii[other]) continue;
        EXPECT_TRUE(visited.contains({other, image})) << "missed";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, LevelGridTest, ::testing::Values(Walls::hard, Walls::periodic), [](const auto& chosen) {
  return std::string(chosen.param == Walls::hard ? "Hard" : "Periodic");
});

TEST(PeriodicImages, OppositesCancel) {
  const PeriodicImages<3> images(side);
  for (std::uint32_t image = 0; image < PeriodicImages<3>::count; ++image) {
    const auto there_and_back = images.shift(image) + images.shift(PeriodicImages<3>::opposite(image));
    EXPECT_EQ(there_and_back, (Vector<3>{0.0, 0.0, 0.0}));
  }
}

TEST(Wrapped, StaysInsideTheBox) {
  EXPECT_DOUBLE_EQ(wrapped(3.25, side), 0.25);
  EXPECT_DOUBLE_EQ(wrapped(-0.25, side), 2.75);
  EXPECT_EQ(wrapped(-1e-30, side), 0.0);
  EXPECT_EQ(wrapped(side, side), 0.0);
}

}  // namespace
}  // namespace breccia
