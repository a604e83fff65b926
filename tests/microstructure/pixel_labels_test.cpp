#include "breccia/microstructure/pixel_labels.hpp"

#include <array>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Values = std::vector<std::int32_t>;

constexpr std::array<ValueLabel, 3> table = {{{255, 0}, {-1, 2}, {128, 1}}};

TEST(PixelLabels, FollowTheTable) {
  const Values values{128, 255, -1, 255};
  EXPECT_THAT(label_mistakes(values, table), IsEmpty());
  EXPECT_THAT(pixel_labels(values, table), ElementsAre(1, 0, 2, 0));
}

TEST(PixelLabels, ReportAllValuesWithoutALabelAndAllThatDoNotOccur) {
  const Values values{255, 254, 254, 255, 7, 254, 255, 255};
  EXPECT_THAT(label_mistakes(values, table),
              ElementsAre("values without a label: 254 (3 pixels, 37.5 %), 7 (1 pixel, 12.5 %)",
                          "no pixel has the value -1", "no pixel has the value 128"));
  test::expect_error<InputError>([&] { static_cast<void>(pixel_labels(values, table)); },
                                 "image: values without a label: 254 (3 pixels, 37.5 %)",
                                 "\nimage: no pixel has the value 128");
}

TEST(PixelLabels, ReportTheTenMostFrequentOfManyValues) {
  Values values(256);
  std::iota(values.begin(), values.end(), 0);
  values.insert(values.end(), 256, 200);
  const auto mistakes = label_mistakes(values, std::array<ValueLabel, 1>{{{0, 0}}});
  EXPECT_THAT(mistakes, ElementsAre("values without a label: 200 (257 pixels, 50.2 %), 1 (1 pixel, 0.195 %), "
                                    "2 (1 pixel, 0.195 %), 3 (1 pixel, 0.195 %), 4 (1 pixel, 0.195 %), "
                                    "5 (1 pixel, 0.195 %), 6 (1 pixel, 0.195 %), 7 (1 pixel, 0.195 %), "
                                    "8 (1 pixel, 0.195 %), 9 (1 pixel, 0.195 %), and 245 more"));
}

TEST(PixelLabels, ReportAValueThatIsLabelledTwice) {
  const std::array<ValueLabel, 3> twice = {{{1, 0}, {2, 1}, {1, 1}}};
  EXPECT_THAT(label_mistakes(Values{1, 2}, twice), ElementsAre("the value 1 has two labels"));
}

}  // namespace
}  // namespace breccia
