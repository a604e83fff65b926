// Tests of the mistakes in boxes of three dimensions that a program makes.

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/expected_mistakes.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using test::mistakes_of;
using testing::HasSubstr;

/// A study with the first of two stages alone, as a box of three dimensions without sizes.
Study study_with(PackingMethod<3> packing) {
  auto study = test::two_stages();
  study.stages.resize(1);
  study.measurements.clear();
  auto& stage = study.stages.front();
  stage.fillers.resize(1);
  stage.fillers.front() = Filler{.material = stage.fillers.front().material};
  stage.packing = std::move(packing);
  return study;
}

double side() {
  return test::two_stages().stages.front().side;
}

ImagePacking<3> stack_of(LabelImage<3> stack) {
  return {.file = "scan.npy", .image = std::make_shared<const LabelImage<3>>(std::move(stack))};
}

ExplicitPacking<3> ellipsoid(const Vector<3>& axes) {
  const double middle = 0.5 * side();
  return {.file = "one.csv", .particles = std::vector{Ellipsoid{{middle, middle, middle}, axes}}};
}

LaguerrePacking<3> grains(const Vector<3>& site) {
  return {.film = 0.01 * side(), .sites = {{site, 0.0}}};
}

TEST(SpaceSoundness, OfBoxesThatAreSound) {
  const double a = side();
  EXPECT_NO_THROW(require_sound(study_with(stack_of({{2, 2, 2}, 0.5 * a, Walls::hard, {0, 1, 1, 0, 0, 0, 0, 1}}))));
  EXPECT_NO_THROW(require_sound(study_with(ellipsoid({0.5 * a, 0.4 * a, 0.3 * a}))));
  EXPECT_NO_THROW(require_sound(study_with(grains({0.5 * a, 0.5 * a, 0.5 * a}))));
}

TEST(SpaceSoundness, EachMistakeIsTold) {
  const double a = side();
  EXPECT_THAT(mistakes_of(study_with(ImagePacking<3>{})), HasSubstr("expected a stack of images"));
  EXPECT_THAT(mistakes_of(study_with(stack_of({{2, 2, 1}, 0.5 * a, Walls::hard, {0, 1, 1, 0}}))),
              HasSubstr("expected a cubic image, got 2 x 2 x 1 pixels"));
  EXPECT_THAT(mistakes_of(study_with(ellipsoid({0.5 * a, 0.4 * a, 1.3 * a}))), HasSubstr("crosses a wall"));
  EXPECT_THAT(mistakes_of(study_with(grains({0.5 * a, 0.5 * a, 1.5 * a}))), HasSubstr("site 1: "));
}

TEST(SpaceSoundness, AngledShapesAreOfThePlane) {
  auto study = study_with(RandomSequentialPacking<3>{});
  auto& filler = study.stages.front().fillers.front();
  filler.fraction = 0.1;
  filler.sizes = SingleSize{0.1 * side()};
  filler.shape = FillerShape{EllipticOutline{2.0}, {}};
  EXPECT_NO_THROW(require_sound(study));
  filler.shape->angle = 0.1;
  EXPECT_THAT(mistakes_of(study), HasSubstr("expected ellipsoids without an angle"));
}

TEST(SpaceSoundness, ThePlacesOfEachKindAreOfTheIdentity) {
  const double a = side();
  const auto differ = [](const Study& one, const Study& other) {
    EXPECT_EQ(content_of(one), content_of(one));
    EXPECT_NE(content_of(one), content_of(other));
  };
  differ(study_with(grains({0.5 * a, 0.5 * a, 0.5 * a})), study_with(grains({0.5 * a, 0.5 * a, 0.6 * a})));
  differ(study_with(ellipsoid({0.5 * a, 0.4 * a, 0.3 * a})), study_with(ellipsoid({0.5 * a, 0.4 * a, 0.2 * a})));
  differ(study_with(stack_of({{1, 1, 2}, a, Walls::hard, {0, 1}})),
         study_with(stack_of({{1, 1, 2}, a, Walls::hard, {1, 0}})));
}

}  // namespace
}  // namespace breccia
