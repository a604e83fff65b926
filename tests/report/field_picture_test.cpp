#include "report/field_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/embedded_pictures.hpp"
#include "report/xml.hpp"

namespace breccia {
namespace {

using test::xml_mistake;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Values 1, 2, ... in a square.
FieldPicture rising(std::size_t columns) {
  FieldPicture picture{.title = "A < B & C", .quantity = "Stress in kPa", .unit_size = 1e3, .columns = columns};
  picture.values.resize(columns * columns);
  std::iota(picture.values.begin(), picture.values.end(), 1.0);
  for (auto& value : picture.values) value *= 1e3;
  return picture;
}

TEST(FieldPicture, HasTitleQuantityAndRange) {
  const auto svg = field_picture(rising(100));
  EXPECT_EQ(xml_mistake(svg), "");
  EXPECT_THAT(svg, HasSubstr("A &lt; B &amp; C"));
  EXPECT_THAT(svg, HasSubstr("Stress in kPa; it goes from 1 to 10000"));
  // The bar goes from the 1st to the 99th of a hundred parts, 100 to 9900; its marks are at round values.
  for (const auto* label : {">2000<", ">4000<", ">6000<", ">8000<"}) EXPECT_THAT(svg, HasSubstr(label));
  EXPECT_THAT(svg, HasSubstr(R"(<path d="M1070 806.122h10")")) << "1000 - 1000 (2000 - 100) / 9800";
}

TEST(FieldPicture, OnALogarithmicScaleTheMiddleIsTheGeometricMean) {
  auto picture = rising(100);
  for (std::size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = i % 2 == 0 ? 1.0 : 1e4;
  picture.values.front() = -1.0;
  picture.unit_size = 1.0;
  picture.scale = ColourScale::logarithmic;
  EXPECT_THAT(field_picture(picture), HasSubstr(">100<"));
}

TEST(FieldPicture, OfBothSignsHasADivergingScale) {
  FieldPicture picture{.columns = 20, .values = {}};
  for (int i = 0; i < 400; ++i) picture.values.push_back(i < 200 ? 0.0 : i < 300 ? -1.0 : 4.0);
  const auto map = test::embedded_pictures(field_picture(picture)).front();
  const auto colour = [&](std::size_t row) { return map.values[row * 20]; };
  // Light grey at zero, half of 255; the same distance from zero is the same distance from it on both sides.
  EXPECT_EQ(colour(0), 128);
  EXPECT_EQ(colour(10), 96) << "127.5 - 127.5 / 4";
  EXPECT_EQ(colour(15), 255);
  std::ranges::transform(picture.values, picture.values.begin(), [](double value) { return value + 1.0; });
  EXPECT_EQ(test::embedded_pictures(field_picture(picture)).front().values.front(), 51) << "from 0 to 5";
}

TEST(FieldPicture, ShowsOutlinesScaleAndLoad) {
  FieldPicture picture{.columns = 2, .values = {1.0, 2.0, 1.0, 2.0}};
  EXPECT_THAT(field_picture(picture), AllOf(Not(HasSubstr("scale-bar")), Not(HasSubstr("load:"))));
  picture.side = 2e-3;
  picture.phases = {0, 1, 0, 1};
  for (const auto load : {DrawnLoad::shear, DrawnLoad::stretch, DrawnLoad::dilatation}) {
    picture.load = load;
    EXPECT_EQ(xml_mistake(field_picture(picture)), "");
    EXPECT_THAT(field_picture(picture), AllOf(HasSubstr("500 µm"), HasSubstr("load:"), HasSubstr(R"(d="M0.5 1v-1")")));
  }
  picture.phases.pop_back();
  EXPECT_THROW(static_cast<void>(field_picture(picture)), InputError);
}

TEST(FieldPicture, OfAUniformFieldHasOneColour) {
  for (const double value : {-2.0, 0.0, 3.0}) {
    for (const auto scale : {ColourScale::linear, ColourScale::logarithmic}) {
      const FieldPicture picture{.columns = 2, .values = std::vector(4, value), .scale = scale};
      EXPECT_EQ(xml_mistake(field_picture(picture)), "") << value;
    }
  }
}

TEST(FieldPicture, IsNoLargerThanAPageCanHold) {
  EXPECT_LT(field_picture(rising(1500)).size(), 600U * 600U * 4U / 3U);
}

TEST(FieldPicture, RefusesInvalidFields) {
  auto picture = rising(3);
  picture.columns = 2;
  EXPECT_THROW(static_cast<void>(field_picture(picture)), InputError);
  picture = rising(3);
  picture.values.front() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(field_picture(picture)), InputError);
}

/// Cuts of a cube of 100 x 100 values each, from 1 to 10 000, 10 001 to 20 000 and 20 001 to 30 000 kPa.
FieldCutsPicture rising_cuts() {
  FieldCutsPicture picture{.title = "A < B", .quantity = "Stress in kPa", .unit_size = 1e3, .columns = 100};
  double value = 0.0;
  for (auto& cut : picture.cuts) {
    for (std::size_t i = 0; i < 10000; ++i) cut.push_back(1e3 * ++value);
  }
  return picture;
}

TEST(FieldPicture, OfACubeHasThreeCutsInOneRangeOfColours) {
  const auto svg = field_cuts_picture(rising_cuts());
  EXPECT_EQ(xml_mistake(svg), "");
  for (const auto* words : {"seen along x", "seen along y", "seen along z", "A &lt; B",
                            "Stress in kPa; it goes from 1 to 30000", ">10000<", ">20000<"}) {
    EXPECT_THAT(svg, HasSubstr(words));
  }
}

TEST(FieldPicture, RefusesInvalidCuts) {
  auto picture = rising_cuts();
  picture.cuts[1].pop_back();
  EXPECT_THROW(static_cast<void>(field_cuts_picture(picture)), InputError);
  picture = rising_cuts();
  picture.cuts[2][5] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(field_cuts_picture(picture)), InputError);
}

}  // namespace
}  // namespace breccia
