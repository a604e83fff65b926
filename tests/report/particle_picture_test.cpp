#include "report/particle_picture.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/xml.hpp"

namespace breccia {
namespace {

using test::count;
using test::xml_mistake;
using ::testing::HasSubstr;

Particle ellipse(const Vector<2>& centre, double angle = 0.0) {
  return {Ellipse{{0.4, 0.2}}, Pose(centre, angle)};
}

TEST(ParticlePicture, DrawsEllipsesAndPolygonsWithYUpwards) {
  const Particle square = {ConvexPolygon({{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}, {0.0, 0.1}}), Pose({0.75, 0.25}, 0.0)};
  const auto picture =
      particle_picture({1.0, Walls::hard, {ellipse({0.3, 0.6}, std::numbers::pi / 6.0), square}, {}, {}});
  EXPECT_EQ(xml_mistake(picture), "");
  EXPECT_THAT(picture,
              HasSubstr(R"svg(<ellipse cx="300" cy="400" rx="200" ry="100" transform="rotate(-30 300 400)"/>)svg"));
  EXPECT_THAT(picture, HasSubstr(R"(<polygon points="700,800 800,800 800,700 700,700 "/>)"));
}

TEST(ParticlePicture, DrawsImagesInAPeriodicBox) {
  const auto ellipses = [](const Vector<2>& centre, Walls walls) {
    return count(particle_picture({1.0, walls, {ellipse(centre)}, {}, {}}), "<ellipse ");
  };
  EXPECT_EQ(ellipses({0.1, 0.5}, Walls::periodic), 2);
  EXPECT_EQ(ellipses({0.1, 0.5}, Walls::hard), 1);
  EXPECT_EQ(ellipses({0.5, 0.15}, Walls::periodic), 1);
  EXPECT_EQ(ellipses({0.1, 0.05}, Walls::periodic), 4);
}

TEST(ParticlePicture, DrawsCoatingsBelowTheirParticles) {
  const ParticleBox box = {1.0, Walls::hard, {ellipse({0.5, 0.5}), ellipse({0.5, 0.2})}, {1, 0}, {0.05, 0.0}};
  const auto picture = particle_picture(box, {{2, 0, 0.0}, {1, 3, 0.05}});
  EXPECT_EQ(xml_mistake(picture), "");
  EXPECT_EQ(count(picture, "<ellipse "), 3);
  EXPECT_THAT(picture, HasSubstr("stroke-width=\"100\""));
  EXPECT_THAT(picture, HasSubstr(colour_of_phase(3)));
  EXPECT_THROW(static_cast<void>(particle_picture(box)), InputError);
}

}  // namespace
}  // namespace breccia
