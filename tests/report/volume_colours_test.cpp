#include "report/volume_colours.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

TEST(VolumeColours, GoFromThe1stToThe99thPercentile) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  values[100] = 1e9;
  const auto [from, to, colours] = volume_colours(ColourScale::linear, values);
  EXPECT_EQ(from, 1.0);
  EXPECT_EQ(to, 99.0);
  EXPECT_THAT((std::vector<int>{colours[0], colours[1], colours[50], colours[99], colours[100]}),
              testing::ElementsAre(0, 0, 128, 255, 255));
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(static_cast<void>(volume_colours(ColourScale::linear, {1.0, wrong})), InputError);
  }
  EXPECT_THROW(static_cast<void>(volume_colours(ColourScale::linear, {})), InputError);
}

TEST(VolumeColours, AreThoseOfThePictures) {
  const auto colours = colours_of_fields();
  EXPECT_EQ(colours.size(), 6 * 256U);
  // The colours run from dark violet to light yellow.
  const auto channel = [&](std::size_t colour, std::size_t which) {
    return std::stoi(colours.substr(6 * colour + 2 * which, 2), nullptr, 16);
  };
  EXPECT_GT(channel(0, 2), channel(0, 1));
  EXPECT_GT(channel(255, 0), 200);
  EXPECT_GT(channel(255, 1), channel(255, 2));
}

}  // namespace
}  // namespace breccia
