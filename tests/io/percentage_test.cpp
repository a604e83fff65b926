#include "io/percentage.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Percentage, IsTheSameNumberAsTheShare) {
  EXPECT_EQ(parse_percentage("35 %"), 0.35);
  EXPECT_EQ(parse_percentage("52.4%"), 0.524);
  EXPECT_EQ(parse_percentage(" 7 % "), 0.07);
  EXPECT_EQ(parse_percentage("-1 %"), -0.01);
}

TEST(Percentage, IsNothingForOtherTexts) {
  for (const auto* text : {"", "%", "35", "35 per cent", "1,5 %", "35 % %", "inf %", "nan %", "3 5 %"}) {
    EXPECT_FALSE(parse_percentage(text)) << text;
  }
}

}  // namespace
}  // namespace breccia
