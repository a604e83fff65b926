#include "report/polygon_picture.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/xml.hpp"

namespace breccia {
namespace {

using test::xml_mistake;
using ::testing::HasSubstr;

/// A box of two halves, the lower of them without a value.
PolygonPicture halves() {
  return {.title = "A < B & C",
          .quantity = "Work",
          .side = 2e-3,
          .polygons = {{.corners = {{0.0, 0.0}, {2e-3, 0.0}, {2e-3, 1e-3}, {0.0, 1e-3}}},
                       {.corners = {{0.0, 1e-3}, {2e-3, 1e-3}, {2e-3, 2e-3}, {0.0, 2e-3}}, .value = 3.0}}};
}

TEST(PolygonPicture, HasTitleQuantityAndRange) {
  auto picture = halves();
  EXPECT_EQ(xml_mistake(polygon_picture(picture)), "");
  EXPECT_THAT(polygon_picture(picture), HasSubstr("A &lt; B &amp; C"));
  EXPECT_THAT(polygon_picture(picture), HasSubstr("Work; it goes from 3 to 3"));
  picture.polygons.front().value = 1.0;
  EXPECT_THAT(polygon_picture(picture), HasSubstr("Work; it goes from 1 to 3"));
}

// A film that no middle of a pixel lies in still shows.
TEST(PolygonPicture, ShowsWhatIsThinnerThanAPixel) {
  auto picture = halves();
  picture.polygons = {
      {.corners = {{1.0001e-3, 0.0}, {1.0002e-3, 0.0}, {1.0002e-3, 2e-3}, {1.0001e-3, 2e-3}}, .value = 1.0}};
  EXPECT_THAT(polygon_picture(picture), HasSubstr("it goes from 1 to 1"));
}

TEST(PolygonPicture, DrawsPeriodicImages) {
  auto picture = halves();
  picture.polygons = {{.corners = {{-1e-3, -1e-3}, {-0.5e-3, -1e-3}, {-0.5e-3, -0.5e-3}}, .value = 1.0}};
  EXPECT_THROW(static_cast<void>(polygon_picture(picture)), InputError) << "it is outside";
  picture.is_periodic = true;
  EXPECT_NO_THROW(static_cast<void>(polygon_picture(picture)));
}

TEST(PolygonPicture, DrawsLaterPolygonsAboveEarlierOnes) {
  auto picture = halves();
  picture.polygons.push_back({.corners = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, .value = 7.0});
  EXPECT_THAT(polygon_picture(picture), HasSubstr("it goes from 7 to 7"));
}

TEST(PolygonPicture, RefusesWhatIsNotFinite) {
  auto picture = halves();
  picture.polygons.back().value = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(polygon_picture(picture)), InputError);
  picture = halves();
  picture.polygons.back().corners.front()[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(polygon_picture(picture)), InputError);
  picture = halves();
  picture.side = 0.0;
  EXPECT_THROW(static_cast<void>(polygon_picture(picture)), InputError);
}

}  // namespace
}  // namespace breccia
