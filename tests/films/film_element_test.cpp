#include "films/assembly/film_element.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "films/assembly/junction_element.hpp"

namespace breccia::films {
namespace {

/// A film along the first axis between two faces; the second one is ahead by `ahead` at both ends.
FilmStretch straight(double length, double thickness, double ahead = 0.0) {
  return {.ends = {{{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(length, 0.0)},
                    {Eigen::Vector2d(ahead, thickness), Eigen::Vector2d(length + ahead, thickness)}}},
          .direction = {1.0, 0.0},
          .normal = {0.0, 1.0},
          .thickness = thickness};
}

using Unknowns = Eigen::Matrix<double, FilmElement::unknowns, 1>;

/// Displacements of an affine motion without flow.
Unknowns affine(const FilmStretch& stretch, const Eigen::Matrix2d& gradient) {
  Unknowns u = Unknowns::Zero();
  Eigen::Index node = 0;
  for (const auto& [begin, end] : stretch.ends) {
    for (const Eigen::Vector2d& position : {begin, Eigen::Vector2d(0.5 * (begin + end)), end}) {
      u.segment<2>(2 * node++) = gradient * position;
    }
  }
  return u;
}

// An incompressible film that is squeezed between rigid faces, without pressure at its ends, resists with g V (L/t)^3
// for the velocity (here displacement) V by the flow alone (Reynolds); in addition its sides shear and stretch it.
TEST(FilmElement, IsSqueezedOutAsReynoldsHasIt) {
  constexpr double length = 0.7, thickness = 0.02, closing = 1e-3;
  const auto element = film_element(straight(length, thickness));
  Unknowns u = Unknowns::Zero();
  for (const int node : {3, 4, 5}) u[2 * node + 1] = -closing;
  // Only the middle pressure is free: its work on the closing equals that on the flow.
  const auto flow_part = element.shear.bottomRightCorner<2, 2>();
  const Eigen::RowVector2d of_flow = element.dilatation.row(1).tail<2>();
  const double pressure =
      (element.dilatation.row(1) * u).value() / (of_flow * flow_part.inverse() * of_flow.transpose()).value();
  const Eigen::Vector2d flow = -pressure * flow_part.inverse() * of_flow.transpose();
  EXPECT_NEAR(flow[1], closing * length / (2.0 * thickness), 1e-12);
  EXPECT_NEAR(flow[0], -flow[1], 1e-12);
  EXPECT_NEAR(flow.dot(flow_part * flow) / (closing * closing * std::pow(length / thickness, 3)), 1.0, 1e-12);
  EXPECT_NEAR(u.dot(element.shear * u) / (4.0 / 3.0 * closing * closing * length / thickness), 1.0, 1e-12);
}

TEST(FilmElement, SlidesWithItsShear) {
  const auto element = film_element(straight(0.7, 0.02));
  Unknowns u = Unknowns::Zero();
  for (const int node : {3, 4, 5}) u[2 * node] = 1e-3;
  EXPECT_NEAR(u.dot(element.shear * u) / (1e-6 * 0.7 / 0.02), 1.0, 1e-12);
  EXPECT_LT((element.dilatation * u).cwiseAbs().maxCoeff(), 1e-18);
}

// The elements have oblique ends, or a vanished face.
TEST(FilmElement, IsExactForUniformStrains) {
  auto triangle = straight(0.7, 0.02);
  triangle.ends[1][0] = triangle.ends[1][1] = {0.3, 0.02};
  auto trapezium = straight(0.7, 0.02);
  trapezium.ends[1][0] = {-0.01, 0.02};
  for (const auto& [stretch, area] :
       {std::pair(straight(0.7, 0.02, 0.015), 0.014), std::pair(triangle, 0.007), std::pair(trapezium, 0.0141)}) {
    const auto element = film_element(stretch);
    EXPECT_NEAR(element.volume.sum(), area, 1e-15);
    const auto u = affine(stretch, Eigen::Matrix2d{{1.0, 0.5}, {0.7, 3.0}});
    // Twice the energy is 2 (eps : eps - tr^2 / 3) times the area.
    EXPECT_NEAR(u.dot(element.shear * u), 2.0 * (1.0 + 9.0 + 2.0 * 0.36 - 16.0 / 3.0) * area, 1e-12);
    EXPECT_NEAR((element.dilatation * u).sum(), 4.0 * area, 1e-14);
  }
}

TEST(SlidingFilmElement, IsFreeToSlideAndToTurn) {
  const auto stretch = straight(0.7, 0.02, 0.015);
  const auto element = sliding_film_element(stretch);
  Unknowns slide = Unknowns::Zero();
  for (const int node : {3, 4, 5}) slide[2 * node] = 1e-3;
  // The binder stays with the first side.
  slide.tail<2>().setConstant(-0.5e-3);
  EXPECT_NEAR(slide.dot(element.shear * slide), 0.0, 1e-15);
  const auto turn = affine(stretch, Eigen::Matrix2d{{0.0, -1.0}, {1.0, 0.0}});
  EXPECT_NEAR(turn.dot(element.shear * turn), 0.0, 1e-14);
  EXPECT_LT((element.dilatation * turn).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(SlidingFilmElement, StretchesAndChangesItsVolumeLikeOneThatAdheres) {
  const auto stretch = straight(0.7, 0.02, 0.015);
  const auto sliding = sliding_film_element(stretch), adhering = film_element(stretch);
  const auto u = affine(stretch, Eigen::Matrix2d{{1.0, 0.0}, {0.0, 3.0}});
  EXPECT_NEAR(u.dot(sliding.shear * u), u.dot(adhering.shear * u), 1e-13);
  EXPECT_EQ(sliding.dilatation, adhering.dilatation);
  EXPECT_EQ(sliding.volume, adhering.volume);
}

TEST(SlidingFilmElement, FlowsWithAQuarterOfTheResistance) {
  const auto stretch = straight(0.7, 0.02);
  Unknowns flow = Unknowns::Zero();
  flow.tail<2>() << 1e-3, -2e-3;
  EXPECT_NEAR(flow.dot(sliding_film_element(stretch).shear * flow) / flow.dot(film_element(stretch).shear * flow), 0.25,
              1e-13);
}

TEST(JunctionElement, IsExactForUniformStrains) {
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2.0, 0.0),
                                                  Eigen::Vector2d(2.0, 1.0), Eigen::Vector2d(0.0, 1.5)};
  const auto element = junction_element(corners);
  const Eigen::Matrix2d gradient{{1.0, 0.5}, {0.7, 3.0}};
  Eigen::VectorXd u(8);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    u.segment<2>(2 * static_cast<Eigen::Index>(c)) = gradient * corners[c];
  }
  EXPECT_NEAR(element.area, 2.5, 1e-14);
  EXPECT_NEAR(element.dilatation * u, 4.0 * 2.5, 1e-13);
  EXPECT_NEAR(u.dot(element.shear * u), 2.0 * (1.0 + 9.0 + 2.0 * 0.36 - 16.0 / 3.0) * 2.5, 1e-12);
}

TEST(JunctionElement, OfTwoCornersIsEmpty) {
  const auto element = junction_element(std::array<Eigen::Vector2d, 2>{Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}});
  EXPECT_EQ(element.area, 0.0);
  EXPECT_EQ(element.shear.norm(), 0.0);
}

}  // namespace
}  // namespace breccia::films
