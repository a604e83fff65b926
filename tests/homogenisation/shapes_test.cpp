#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/point_labels.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/box/stage_microstructure_state.hpp"
#include "homogenisation/run/packed_stage.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double quarter_turn = 0.5 * std::numbers::pi;
constexpr std::array three_loads = {Load::shear, Load::diagonal_shear, Load::bulk};
const Material soft_host = {"soft_host", 1000.0, PronySeries(3e9), PronySeries(1e9)};
const Material stiff_grain = {"stiff_grain", 2500.0, PronySeries(40e9), PronySeries(30e9)};
const Material grain_layer = {"grain_layer", 1200.0, PronySeries(8e9), PronySeries(4e9)};

/// A periodic box of side 1 with these particles, elastic.
Stage listed_box(const std::vector<Particle>& particles, int cells) {
  return {.name = "cell",
          .matrix = soft_host,
          .side = 1.0,
          .cells = cells,
          .fillers = {Filler{.material = stiff_grain}},
          .packing = ExplicitPacking<2>{"", particles, Walls::periodic}};
}

/// A box of 10 mm with ellipses at random.
Stage ellipse_stage(double fraction, Walls walls, double aspect = 1.5) {
  Filler filler = {.material = stiff_grain, .fraction = fraction, .sizes = SingleSize{1e-3}, .gap = 0.02e-3};
  filler.shape = FillerShape{EllipticOutline{aspect}, {}};
  return {.name = "A",
          .matrix = soft_host,
          .side = 10e-3,
          .cells = 100,
          .fillers = {filler},
          .packing = RandomSequentialPacking<2>{walls, 2}};
}

struct Stiffness {
  double xx, yy, shear;
};

/// The stiffness of a periodic box from the mean stresses under the loads.
Stiffness stiffness_of(const Stage& stage) {
  Study study;
  study.stages = {stage};
  study.tests.boundaries = {Boundary::periodic};
  study.tests.first_time = 1.0;
  study.tests.last_time = 10.0;
  study.tests.field_times = {1.0};
  study.tests.quasistatic.linear.tolerance = 1e-12;
  const auto stress = [&](Load load) {
    study.tests.loads = {load};  // the fields are those of the first load
    const auto result = solve(study);
    const auto& test = preferred_test(result.stages.front().tests, load, Boundary::periodic);
    const auto& fields = std::get<GridFields<2>>(test.fields).at_times.front().fields;
    std::array<double, 4> mean{};
    for (const auto& one : fields.stress) {
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += one[k] / static_cast<double>(fields.stress.size());
    }
    return mean;
  };
  // The unit strains are 1/2 along both axes, 1/2 and -1/2 along x and y, and 1/2 as xy.
  const auto bulk = stress(Load::bulk), diagonal = stress(Load::diagonal_shear), shear = stress(Load::shear);
  return {bulk[0] + diagonal[0], bulk[1] - diagonal[1], shear[3]};
}

// The exact numbers, from tests/reference/elliptic_cylinder.py, are the contribution of an ellipse to the stiffness per
// area fraction. Here it fills 1 % of a periodic cell; the effect of its images is up to 2 % of the contribution.
TEST(Shapes, ADiluteEllipseHasTheExactStiffness) {
  const double fraction = 0.01, second = std::sqrt(2.0 * fraction / std::numbers::pi);
  const auto stiffness = stiffness_of(listed_box({{Ellipse{{2.0 * second, second}}, Pose({0.5, 0.5}, 0.0)}}, 128));
  const double normal = 3e9 + 4.0 / 3.0 * 1e9;
  EXPECT_NEAR((stiffness.xx - normal) / fraction / 6.882978e9, 1.0, 0.02);
  EXPECT_NEAR((stiffness.yy - normal) / fraction / 4.79268097e9, 1.0, 0.02);
  EXPECT_NEAR((stiffness.shear - 1e9) / fraction / 1.44382979e9, 1.0, 0.02);
}

TEST(Shapes, TurningABoxByAQuarterSwapsItsAxes) {
  const std::vector<Particle> particles = {{Ellipse{{0.5, 0.2}}, Pose({0.3, 0.35}, 0.4)},
                                           {Ellipse{{0.3, 0.15}}, Pose({0.8, 0.7}, -0.7)}};
  std::vector<Particle> turned;
  turned.reserve(particles.size());
  for (const auto& [shape, pose] : particles) {
    turned.push_back({shape, Pose({1.0 - pose.centre()[1], pose.centre()[0]}, pose.angle() + quarter_turn)});
  }
  const auto one = stiffness_of(listed_box(particles, 64)), other = stiffness_of(listed_box(turned, 64));
  EXPECT_NEAR(one.xx / other.yy, 1.0, 1e-7);
  EXPECT_NEAR(one.yy / other.xx, 1.0, 1e-7);
  EXPECT_NEAR(one.shear / other.shear, 1.0, 1e-7);
  EXPECT_GT(std::abs(one.xx / one.yy - 1.0), 0.01) << "the axes differ";
}

/// The apparent moduli of a microstructure on a periodic grid.
std::vector<double> periodic_moduli(const Stage& stage, const StageMicrostructure& packed, Mixing mixing) {
  QuasistaticProblem<2> problem{
      .discretisation = std::get<Discretisation<2>>(discretise(stage, packed, stage.cells, mixing)),
      .materials = {soft_host, stiff_grain},
      .boundary = Boundary::periodic};
  problem.linear.tolerance = 1e-13;
  return apparent_moduli(problem, three_loads);
}

double wrapped(double x, double side) {
  return x - side * std::floor(x / side);
}

TEST(Shapes, TranslatingAPeriodicBoxByWholeCellsChangesNothing) {
  auto stage = ellipse_stage(0.5, Walls::periodic);
  stage.cells = 48;
  const auto packed = make_microstructure(stage);
  auto moved = packed;
  for (auto& particle : find_alternative<ParticleBox>(moved.box)->particles) {
    const auto& [x, y] = particle.pose.centre();
    const double h = stage.cell_size();
    particle.pose = particle.pose.at({wrapped(x + 7.0 * h, stage.side), wrapped(y + 12.0 * h, stage.side)});
  }
  for (const auto mixing : {Mixing::series, Mixing::points}) {
    const auto one = periodic_moduli(stage, packed, mixing), other = periodic_moduli(stage, moved, mixing);
    for (std::size_t load = 0; load < three_loads.size(); ++load) EXPECT_NEAR(one[load] / other[load], 1.0, 1e-9);
  }
}

TEST(Grains, TranslatingAPeriodicTessellationByWholeCellsChangesNothing) {
  Stage stage = {.name = "A", .matrix = soft_host, .side = 1.0, .cells = 48};
  stage.fillers = {
      Filler{.material = stiff_grain, .fraction = 0.8, .sizes = SingleSize{std::sqrt(0.4 / std::numbers::pi)}}};
  stage.packing = LaguerrePacking<2>{.seed = 3};
  const auto packed = make_microstructure(stage);
  ASSERT_EQ(packed.particles(), 10U);
  auto moved = packed;
  for (auto& [position, weight] : find_alternative<Grains<2>>(moved.box)->sites.sites) {
    position = {wrapped(position[0] + 7.0 / 48.0, 1.0), wrapped(position[1] + 12.0 / 48.0, 1.0)};
  }
  const auto one = periodic_moduli(stage, packed, Mixing::series),
             other = periodic_moduli(stage, moved, Mixing::series);
  for (std::size_t load = 0; load < three_loads.size(); ++load) EXPECT_NEAR(one[load] / other[load], 1.0, 1e-9);
}

TEST(Shapes, ArePackedWithTheirGapsAndMeasured) {
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    const auto stage = ellipse_stage(0.5, walls);
    const auto packed = make_microstructure(stage);
    ASSERT_NE(packed.content<ParticleBox>(), nullptr);
    EXPECT_EQ(packed.content<ParticleBox>()->walls, walls);
    EXPECT_NEAR(packed.fraction, 0.5, 0.005);
    EXPECT_GE(packed.gap, 0.02e-3);
    EXPECT_GE(packed.wall_gap, 0.02e-3);
    EXPECT_EQ(packed.particles(), packed.content<ParticleBox>()->particles.size());
    ASSERT_EQ(packed.fillers.size(), 1U);
    EXPECT_NEAR(packed.fillers.front().smallest_diameter.value(), 1e-3, 1e-15);
    EXPECT_NEAR(packed.fillers.front().fraction, packed.fraction, 1e-15);
    EXPECT_TRUE(packed.fillers.front().size_deviation);
    EXPECT_GT(packed.events, 0U);
  }
}

TEST(Shapes, AreInTheCellsAsInTheBox) {
  const auto stage = ellipse_stage(0.5, Walls::periodic);
  const auto packed = make_microstructure(stage);
  EXPECT_NEAR(fractions(discretise(stage, packed, 100, Mixing::series), 2)[1], packed.fraction, 1e-3);
  EXPECT_NEAR(fractions(discretise(stage, packed, 400, Mixing::points), 2)[1], packed.fraction, 1e-3);
}

TEST(Shapes, CoatingsAreInTheCellsAsInTheBox) {
  auto stage = ellipse_stage(0.3, Walls::periodic, 2.0);
  stage.fillers.front().coating = Coating{grain_layer, 0.1e-3};
  const auto packed = make_microstructure(stage);
  const auto& own = packed.fillers.front();
  EXPECT_GE(packed.gap, 0.02e-3) << "between coatings";
  const auto fractions = breccia::fractions(discretise(stage, packed, 200, Mixing::series), 3);
  EXPECT_NEAR(fractions[1], own.fraction, 1e-3);
  EXPECT_NEAR(fractions[2], own.coating_fraction, 1e-3);
}

TEST(Shapes, LabelThePointsInThemAndInTheirCoatings) {
  auto stage =
      listed_box({{Ellipse{{0.4, 0.2}}, Pose({0.25, 0.25}, 0.0)}, {Ellipse{{0.2, 0.4}}, Pose({0.7, 0.7}, 0.0)}}, 40);
  stage.fillers.front().coating = Coating{grain_layer, 0.05};
  const auto labels = point_labels(stage, make_microstructure(stage), 40);
  const auto at = [](double x, double y) {
    return static_cast<std::size_t>(80.0 * y) * 80 + static_cast<std::size_t>(80.0 * x);
  };
  EXPECT_EQ(labels.particles[at(0.43, 0.25)], 0);
  EXPECT_EQ(labels.phases[at(0.43, 0.25)], 1);
  EXPECT_EQ(labels.particles[at(0.47, 0.25)], 0);
  EXPECT_EQ(labels.phases[at(0.47, 0.25)], 2);
  EXPECT_EQ(labels.particles[at(0.7, 0.88)], 1);
  EXPECT_EQ(labels.particles[at(0.9, 0.9)], -1);
  EXPECT_EQ(labels.phases[at(0.9, 0.9)], 0);
}

TEST(Shapes, SeveralFillersAreInOnePacking) {
  auto stage = ellipse_stage(0.3, Walls::periodic);
  Filler squares = {.material = grain_layer, .fraction = 0.2, .sizes = SingleSize{0.8e-3}, .gap = 0.02e-3};
  squares.shape = FillerShape{PolygonalOutline{"", {{0.0, 0.0}, {3.0, 0.0}, {3.0, 3.0}, {0.0, 3.0}}}, 0.25};
  stage.fillers.push_back(squares);
  Filler discs = {.material = grain_layer, .fraction = 0.05, .sizes = SingleSize{0.4e-3}, .gap = 0.02e-3};
  stage.fillers.push_back(discs);
  const auto packed = make_microstructure(stage);
  ASSERT_EQ(packed.fillers.size(), 3U);
  EXPECT_NEAR(packed.fillers[0].fraction, 0.3, 0.01);
  EXPECT_NEAR(packed.fillers[1].fraction, 0.2, 0.01);
  EXPECT_NEAR(packed.fillers[2].fraction, 0.05, 0.01);
  EXPECT_NEAR(packed.fillers[1].largest_diameter.value(), 0.8e-3, 1e-15);
  EXPECT_EQ(packed.content<ParticleBox>()->particles[packed.fillers[0].particles].pose.angle(), 0.25);
  EXPECT_GE(packed.gap, 0.02e-3);
}

TEST(Shapes, CirclesAreDiscs) {
  const auto packed = make_microstructure(listed_box({{Ellipse{{0.2, 0.2}}, Pose({0.3, 0.4}, 1.0)}}, 16));
  ASSERT_NE(packed.content<Microstructure<2>>(), nullptr);
  EXPECT_THAT(packed.content<Microstructure<2>>()->particles, ElementsAre(Disc{{0.3, 0.4}, 0.2}));
  auto discs = ellipse_stage(0.4, Walls::hard);
  discs.fillers.front().shape.reset();
  EXPECT_NE(make_microstructure(discs).content<Microstructure<2>>(), nullptr);
}

TEST(Shapes, AreReadFromTheirState) {
  auto stage = ellipse_stage(0.3, Walls::periodic);
  Filler triangles = {.material = grain_layer, .fraction = 0.1, .sizes = SingleSize{0.8e-3}, .gap = 0.02e-3};
  triangles.shape = FillerShape{PolygonalOutline{"", {{0.0, 0.0}, {3.0, 0.0}, {1.0, 2.0}}}, {}};
  triangles.coating = Coating{grain_layer, 0.01e-3};
  stage.fillers.push_back(triangles);
  const auto packed = make_microstructure(stage);
  const test::TemporaryDirectory directory;
  {
    StateWriter state(directory.path() / "particles.h5", {"deck", "1.0"});
    save(state, packed);
    state.commit();
  }
  const auto read = read_stage_microstructure(StateReader(directory.path() / "particles.h5"), stage);
  ASSERT_NE(read.content<ParticleBox>(), nullptr);
  EXPECT_EQ(read.content<ParticleBox>()->particles, packed.content<ParticleBox>()->particles);
  EXPECT_EQ(read.content<ParticleBox>()->fillers, packed.content<ParticleBox>()->fillers);
  EXPECT_EQ(read.content<ParticleBox>()->coatings, packed.content<ParticleBox>()->coatings);
  EXPECT_EQ(read.gap, packed.gap);
}

TEST(Shapes, BeginAnewAfterAnInterruptionAndComeToTheSameBits) {
  const auto stage = ellipse_stage(0.5, Walls::periodic);
  const auto whole = make_microstructure(stage);
  const test::TemporaryDirectory directory;
  const auto make = [&](bool ends) {
    Checkpoint checkpoint(directory.path() / "packing.checkpoint.h5", {"deck", "1.0"},
                          {.stop = [ends] { return ends; }});
    EXPECT_THAT(checkpoint.look_for_earlier(), testing::IsEmpty());
    return make_microstructure(stage, {}, &checkpoint);
  };
  EXPECT_THROW(static_cast<void>(make(true)), Interrupted);
  EXPECT_EQ(make(false).content<ParticleBox>()->particles, whole.content<ParticleBox>()->particles);
  EXPECT_EQ(make(false).content<ParticleBox>()->particles, whole.content<ParticleBox>()->particles) << "finished";
}

TEST(Shapes, ThatJamSayHowFarTheyCame) {
  auto stage = ellipse_stage(0.8, Walls::hard);
  stage.fillers.front().sizes = SingleSize{3e-3};
  stage.fillers.front().gap = 0.5e-3;
  EXPECT_THAT(test::message_of<NumericalError>([&] { static_cast<void>(make_microstructure(stage)); }),
              AllOf(HasSubstr("A: "), HasSubstr("particles of 3 mm"), HasSubstr("jam"), HasSubstr("stuck at")));
}

TEST(Shapes, ThatDoNotFitAreNamed) {
  auto stage = ellipse_stage(0.5, Walls::hard, 30.0);
  stage.fillers.front().sizes = ListedSizes{{5e-3}};
  stage.fillers.front().fraction.reset();
  EXPECT_THAT(test::message_of<NumericalError>([&] { static_cast<void>(make_microstructure(stage)); }),
              HasSubstr("does not fit into a box of 10 mm"));
}

TEST(Shapes, ThatCrossTheSidesOfABoxAreWarnedOf) {
  auto stage = listed_box({{Ellipse{{0.5, 0.2}}, Pose({0.1, 0.5}, 0.0)}}, 32);
  Study study;
  study.stages = {stage};
  study.tests.boundaries = {Boundary::displacement};
  study.tests.first_time = 1.0;
  study.tests.last_time = 10.0;
  const auto warned = packed_stage(study, stage, make_microstructure(stage)).warnings;
  EXPECT_THAT(warned, testing::Contains(HasSubstr("the sides of the box cut filler, over")));
}

}  // namespace
}  // namespace breccia
