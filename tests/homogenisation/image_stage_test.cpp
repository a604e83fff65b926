// Tests of stages that are images, and of the labels of the points of other stages.

#include <algorithm>
#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/point_labels.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/stage_warnings.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Material bitumen = {"bitumen", 1000.0, PronySeries(1e9), PronySeries(1e4, {{0.01, 0.5e6}})};
const Material flint = {"flint", 2000.0, PronySeries(10e9), PronySeries(5e9)};
const Material iron = {"iron", 7800.0, PronySeries(160e9), PronySeries(80e9)};

/// A box of 4 mm with a layer of flint above a layer of iron, each a quarter of the box.
Stage layered_image(Walls walls) {
  const LabelImage<2> image = {{4, 4}, 1e-3, walls, {0, 0, 0, 0, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0}};
  return {.name = "A",
          .matrix = bitumen,
          .side = 4e-3,
          .cells = 4,
          .fillers = {{.material = flint}, {.material = iron}},
          .packing = ImagePacking<2>{.file = "layers.png", .image = std::make_shared<const LabelImage<2>>(image)}};
}

Study image_study(const Stage& stage, Mixing mixing) {
  Study study;
  study.stages = {stage};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 1e-2;
  study.tests.mixing = mixing;
  return study;
}

TEST(ImageStage, HasFractionsAndAnInterfaceButNoGap) {
  const auto packed = make_microstructure(layered_image(Walls::hard));
  EXPECT_DOUBLE_EQ(packed.fraction, 0.5);
  ASSERT_EQ(packed.fillers.size(), 2U);
  EXPECT_DOUBLE_EQ(packed.fillers[1].fraction, 0.25);
  EXPECT_DOUBLE_EQ(packed.interface_per_area, 3.0 / 4e-3);
  EXPECT_EQ(packed.particles(), 0U);
  EXPECT_TRUE(std::isinf(packed.gap) && std::isinf(packed.wall_gap));
}

TEST(ImageStage, HasThePhasesOfItsFillers) {
  const auto stage = layered_image(Walls::hard);
  const auto packed = make_microstructure(stage);
  EXPECT_THAT(phases_of(stage).names(), ElementsAre("matrix", "flint", "iron"));
  EXPECT_THAT(fractions(discretise(stage, packed, 4, Mixing::points), 3), ElementsAre(0.5, 0.25, 0.25));
  const auto mixed = std::get<Discretisation<2>>(discretise(stage, packed, 2, Mixing::series));
  EXPECT_THAT(mixed.fractions(3), ElementsAre(0.5, 0.25, 0.25));
  EXPECT_EQ(mixed.mixtures().size(), 2U) << "matrix and iron, flint and matrix";
}

// The layers cut the sides across them, over half of their length, and not the others.
TEST(ImageStage, WarnsOfABoundaryThatCutsItsFiller) {
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    const auto stage = layered_image(walls);
    auto study = image_study(stage, Mixing::series);
    const auto packed = make_microstructure(stage);
    study.tests.boundaries = {Boundary::traction};
    EXPECT_THAT(warnings_on(study, stage, packed),
                Contains(HasSubstr("the sides of the box cut filler, over 25 % of their length: ")));
    study.tests.boundaries = {Boundary::periodic};
    EXPECT_THAT(warnings_on(study, stage, packed),
                ElementsAre(HasSubstr("a line of pixels crosses its filler in 2.7 pixels")))
        << "the sides fit together, and flint with iron is 2 or 4 pixels long";
  }
}

/// A stage whose 16 x 16 pixels of flint in bitumen are given by a rule of column and row.
template <class IsFlint>
Stage picture(const IsFlint& is_flint) {
  LabelImage<2> image = {{16, 16}, 1e-3, Walls::periodic, {}};
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) image.labels.push_back(is_flint(column, row) ? Label{1} : Label{0});
  }
  return {.name = "A",
          .matrix = bitumen,
          .side = 16e-3,
          .cells = 8,
          .fillers = {{.material = flint}},
          .packing = ImagePacking<2>{.file = "scan.png", .image = std::make_shared<const LabelImage<2>>(image)}};
}

std::vector<std::string> warnings_of(const Stage& stage) {
  auto study = image_study(stage, Mixing::series);
  study.tests.boundaries = {Boundary::periodic};
  return warnings_on(study, stage, make_microstructure(stage));
}

TEST(ImageStage, WarnsOfSidesThatDoNotFitTogether) {
  EXPECT_THAT(warnings_of(picture([](int column, int) { return column >= 4 && column < 12; })), IsEmpty());
  EXPECT_THAT(warnings_of(picture([](int column, int row) { return row >= column; })),
              Contains(AllOf(HasSubstr("opposite sides of the picture do not fit together: 94 % of their pixels"),
                             HasSubstr("at most 6 % of those of neighbouring lines inside"),
                             HasSubstr("100 % of the filler"))));
}

TEST(ImageStage, WarnsOfNoiseAndOfPixelsThatAreTooLarge) {
  EXPECT_THAT(warnings_of(picture([](int column, int row) { return (column + 3 * row) % 7 == 0; })),
              Contains(AllOf(HasSubstr("single pixels of another material than all around them have 100 % of the "
                                       "interface"),
                             HasSubstr("packing.smooth = 3"))));
  EXPECT_THAT(warnings_of(picture([](int column, int) { return column % 8 < 6; })),
              Contains(HasSubstr("100 % of the gaps between its filler, along lines of pixels, are narrower than 3 "
                                 "pixels (1.5 cells)")))
      << "gaps of two pixels";
  auto coarse = picture([](int column, int) { return column < 6 || column >= 10; });
  EXPECT_THAT(warnings_of(coarse), IsEmpty()) << "gaps of four";
  coarse.cells = 4;
  EXPECT_THAT(warnings_of(coarse), Contains(HasSubstr("are narrower than 6 pixels (1.5 cells)")));
}

TEST(ImageStage, WarnsOfAPoorThresholdAndOfAFrame) {
  auto stage = picture([](int column, int) { return column >= 4 && column < 12; });
  auto& made = std::get<ImagePacking<2>>(std::get<PackingMethod<2>>(stage.packing)).segmentation.emplace();
  made.separability = 0.76;
  EXPECT_THAT(warnings_of(stage), IsEmpty());
  made.separability = 0.74;
  made.frame = 3;
  EXPECT_THAT(warnings_of(stage),
              ElementsAre(HasSubstr("hardly separates the grey values: Otsu's separability is 0.74, "
                                    "and that of a flat histogram 0.75"),
                          HasSubstr("the outermost 3 lines of pixels at a side of the picture have "
                                    "one grey value throughout")));
}

TEST(ImageStage, TakesTheMemoryOfItsMixedCells) {
  const auto stage = layered_image(Walls::hard);
  const auto points = image_study(stage, Mixing::points), series = image_study(stage, Mixing::series);
  // Three interfaces cross at most 3 of 300 rows of cells.
  const double share = quasistatic_memory(series, stage, 300) / quasistatic_memory(points, stage, 300);
  EXPECT_GT(share, 1.0);
  EXPECT_LT(share, 1.02);
}

TEST(PointLabels, TellTheParticleOfEveryPointWithItsCoating) {
  // The stage has a disc in the corner of a periodic box, and one in the middle.
  Stage stage = {.name = "A", .matrix = bitumen, .side = 1.0, .cells = 20};
  stage.fillers = {{.material = flint, .coating = Coating{iron, 0.1}}};
  stage.packing =
      ExplicitPacking<2>{"discs.csv", std::vector<Disc>{{{0.0, 0.0}, 0.4}, {{0.5, 0.5}, 0.4}}, Walls::periodic};
  const auto labels = point_labels(stage, make_microstructure(stage), stage.cells);
  ASSERT_EQ(labels.phases.size(), 1600U);
  ASSERT_EQ(labels.particles.size(), 1600U);
  const auto at = [&](std::size_t column, std::size_t row) {
    return std::pair(labels.phases[row * 40 + column], labels.particles[row * 40 + column]);
  };
  EXPECT_EQ(at(0, 0), std::pair(PhaseIndex{1}, 0));
  EXPECT_EQ(at(39, 39), std::pair(PhaseIndex{1}, 0)) << "its image";
  EXPECT_EQ(at(10, 0), std::pair(PhaseIndex{2}, 0)) << "its coating";
  EXPECT_EQ(at(20, 20), std::pair(PhaseIndex{1}, 1));
  EXPECT_EQ(at(20, 0), std::pair(PhaseIndex{0}, -1));
  EXPECT_EQ(std::ranges::count(labels.phases, 0), std::ranges::count(labels.particles, -1));
}

}  // namespace
}  // namespace breccia
