#include "breccia/report/microstructure_picture.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/xml.hpp"

namespace breccia {
namespace {

using test::count;
using test::xml_mistake;
using ::testing::HasSubstr;

/// The paper's model composite: 2 x 2 discs of 2 mm in a box of 6 mm.
const Microstructure<2> model_composite{
    6e-3,
    Walls::hard,
    {{{1.5e-3, 1.5e-3}, 2e-3}, {{4.5e-3, 1.5e-3}, 2e-3}, {{1.5e-3, 4.5e-3}, 2e-3}, {{4.5e-3, 4.5e-3}, 2e-3}}};

std::size_t circles(const Microstructure<2>& microstructure) {
  return count(microstructure_picture(microstructure), "<circle ");
}

TEST(MicrostructurePicture, IsWellFormed) {
  EXPECT_EQ(xml_mistake(microstructure_picture(model_composite)), "");
  EXPECT_EQ(xml_mistake(microstructure_picture({1e-6, Walls::periodic, {}})), "");
}

TEST(MicrostructurePicture, DrawsDiscsToScaleWithYUpwards) {
  EXPECT_EQ(circles(model_composite), 4);
  EXPECT_THAT(microstructure_picture({2e-3, Walls::hard, {{{0.5e-3, 1.7e-3}, 0.4e-3}}}),
              HasSubstr(R"(<circle cx="250" cy="150" r="100"/>)"));
}

TEST(MicrostructurePicture, DrawsTheImagesOfAPeriodicBox) {
  const auto in_periodic_box = [](Vector<2> centre) { return circles({1.0, Walls::periodic, {{centre, 0.2}}}); };
  EXPECT_EQ(in_periodic_box({0.5, 0.5}), 1);
  EXPECT_EQ(in_periodic_box({0.95, 0.5}), 2);
  EXPECT_EQ(in_periodic_box({0.5, 0.05}), 2);
  EXPECT_EQ(in_periodic_box({0.95, 0.05}), 4);
  EXPECT_EQ(in_periodic_box({0.92, 0.08}), 3) << "near two sides, but the corner stays free";
  EXPECT_EQ(circles({1.0, Walls::hard, {{{0.95, 0.05}, 0.2}}}), 1);
}

TEST(MicrostructurePicture, PutsImagesOnTheOppositeSideAndClipsThem) {
  const auto picture = microstructure_picture({1.0, Walls::periodic, {{{0.95, 0.5}, 0.2}}});
  EXPECT_THAT(picture, HasSubstr(R"(<circle cx="950" cy="500" r="100"/>)"));
  EXPECT_THAT(picture, HasSubstr(R"(<circle cx="-50" cy="500" r="100"/>)"));
  EXPECT_THAT(picture, HasSubstr(R"(<clipPath id="box"><rect width="1000" height="1000"/></clipPath>)"));
  EXPECT_THAT(picture, HasSubstr(R"svg(<g clip-path="url(#box)")svg"));
}

TEST(MicrostructurePicture, HasAScaleBarOfRoundLength) {
  const auto with_side = [](double side) { return microstructure_picture({side, Walls::hard, {}}); };
  EXPECT_THAT(with_side(48e-6), HasSubstr(">10 µm</text>"));
  EXPECT_THAT(with_side(40e-6), HasSubstr(R"(width="250" height="10")")) << "exactly a quarter of the side";
  EXPECT_THAT(with_side(6e-3), HasSubstr(">1 mm</text>"));
  EXPECT_THAT(with_side(2.75e-3), HasSubstr(">500 µm</text>"));
  EXPECT_THAT(with_side(900e-9), HasSubstr(">200 nm</text>"));
}

TEST(MicrostructurePicture, GivesEachFillerAndCoatingItsColour) {
  const Microstructure<2> box = {1.0, Walls::hard, {{{0.25, 0.5}, 0.2}, {{0.75, 0.5}, 0.2}}, {0, 1}};
  const auto picture =
      microstructure_picture(box, {{.colour = 1}, {.colour = 2, .coating_colour = 3, .coating_thickness = 0.05}});
  EXPECT_THAT(picture, HasSubstr(R"(<circle cx="250" cy="500" r="100"/>)"));
  const auto coating = picture.find(R"(<circle cx="750" cy="500" r="150" fill="#6b8e4e"/>)");
  const auto core = picture.find(R"(<circle cx="750" cy="500" r="100" fill="#b5652b"/>)");
  ASSERT_NE(coating, std::string::npos);
  ASSERT_NE(core, std::string::npos);
  EXPECT_LT(coating, core) << "the core is drawn above its coating";
  EXPECT_THROW((void)microstructure_picture(box), InputError) << "of two fillers only one is given";
}

TEST(MicrostructurePicture, RefusesABoxWithoutASize) {
  EXPECT_THROW(microstructure_picture({}), InputError);
  EXPECT_THROW(microstructure_picture({-1.0, Walls::hard, {}}), InputError);
}

}  // namespace
}  // namespace breccia
