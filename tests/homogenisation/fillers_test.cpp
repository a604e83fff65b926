#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/whole_filler.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Material rubber = {"rubber", 1000.0, PronySeries(1e9), PronySeries(1e4, {{0.01, 0.5e6}})};
const Material sand = {"sand", 2000.0, PronySeries(10e9), PronySeries(5e9)};
const Material steel = {"steel", 7800.0, PronySeries(160e9), PronySeries(80e9)};
const Material wax = {"wax", 900.0, PronySeries(1e9), PronySeries(0.1e9)};

Filler filler_of(const Material& material, std::vector<double> diameters, double gap = 0.2e-3) {
  return {.material = material, .sizes = ListedSizes{std::move(diameters)}, .gap = gap};
}

/// A box of 10 mm with particles at random.
Stage box_with(std::vector<Filler> fillers, Walls walls = Walls::hard) {
  return {.name = "box",
          .matrix = rubber,
          .side = 10e-3,
          .cells = 60,
          .fillers = std::move(fillers),
          .packing = LubachevskyStillingerPacking<2>{walls, 3}};
}

Study study_with(const Stage& stage) {
  Study study;
  study.stages = {stage};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 0.1;
  return study;
}

double distance(const Disc& one, const Disc& other) {
  return std::hypot(one.centre[0] - other.centre[0], one.centre[1] - other.centre[1]) -
         0.5 * (one.diameter + other.diameter);
}

TEST(Fillers, TwoOfOneMaterialHaveTheBitsOfTheirUnion) {
  const auto two = solve(study_with(box_with({filler_of(sand, {3e-3, 2e-3}), filler_of(sand, {1e-3, 1e-3, 2e-3})})));
  const auto one = solve(study_with(box_with({filler_of(sand, {3e-3, 2e-3, 1e-3, 1e-3, 2e-3})})));
  const auto &of_two = two.stages.front(), &of_one = one.stages.front();
  EXPECT_EQ(of_two.microstructure.content<Microstructure<2>>()->particles,
            of_one.microstructure.content<Microstructure<2>>()->particles);
  EXPECT_THAT(of_two.microstructure.content<Microstructure<2>>()->fillers, ElementsAre(0, 0, 1, 1, 1));
  ASSERT_EQ(of_two.tests.size(), of_one.tests.size());
  for (std::size_t test = 0; test < of_one.tests.size(); ++test) {
    EXPECT_EQ(of_two.tests[test].modulus, of_one.tests[test].modulus);
  }
}

TEST(Fillers, KeepTheMeanOfTheirGaps) {
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    const auto packed = make_microstructure(box_with(
        {filler_of(sand, std::vector(8, 1.5e-3), 0.1e-3), filler_of(steel, std::vector(8, 1.5e-3), 0.5e-3)}, walls));
    const auto& [side, kind, discs, fillers] = *packed.content<Microstructure<2>>();
    const std::vector<double> gaps = {0.1e-3, 0.5e-3};
    for (std::size_t i = 0; i < discs.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(distance(discs[i], discs[j]), 0.5 * (gaps[fillers[i]] + gaps[fillers[j]]) - 1e-15);
      }
      if (walls == Walls::periodic) continue;
      const double to_wall = 0.5 * (gaps[fillers[i]] + 0.1e-3) + 0.5 * discs[i].diameter - 1e-15;
      for (const double x : discs[i].centre) {
        EXPECT_GE(x, to_wall);
        EXPECT_LE(x, side - to_wall);
      }
    }
  }
}

TEST(Fillers, KeepTheirGapsBetweenCoatings) {
  auto coated = filler_of(sand, std::vector(6, 1.5e-3));
  coated.coating = Coating{wax, 0.3e-3};
  const auto packed = make_microstructure(box_with({coated, filler_of(steel, std::vector(6, 1e-3))}));
  const auto& [side, walls, discs, fillers] = *packed.content<Microstructure<2>>();
  const std::vector<double> coatings = {0.3e-3, 0.0};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(distance(discs[i], discs[j]), 0.2e-3 + coatings[fillers[i]] + coatings[fillers[j]] - 1e-15);
    }
  }
  EXPECT_GE(packed.gap, 0.2e-3 - 1e-15);
  EXPECT_GE(packed.wall_gap, 0.2e-3 - 1e-15);
  ASSERT_EQ(packed.fillers.size(), 2U);
  EXPECT_EQ(packed.fillers[0].particles, 6U);
  EXPECT_NEAR(packed.fillers[0].fraction, 6.0 * pi / 4.0 * 2.25 / 100.0, 1e-12);
  EXPECT_NEAR(packed.fillers[0].coating_fraction, 6.0 * pi / 4.0 * (2.1 * 2.1 - 2.25) / 100.0, 1e-12);
  EXPECT_NEAR(packed.fillers[1].fraction, 6.0 * pi / 4.0 / 100.0, 1e-12);
  EXPECT_EQ(packed.fillers[1].largest_diameter, 1e-3);
}

TEST(Fillers, AreDrawnEachFromItsOwnSizes) {
  Filler coarse = {.material = sand, .fraction = 0.3, .sizes = SingleSize{1.5e-3}, .gap = 0.1e-3};
  Filler fine = {.material = steel, .fraction = 0.1, .sizes = SingleSize{0.7e-3}, .gap = 0.1e-3};
  const auto packed = make_microstructure(box_with({coarse, fine}));
  EXPECT_NEAR(packed.fillers.at(0).fraction, 0.3, pi / 8.0 * 0.0225 + 1e-12);
  EXPECT_NEAR(packed.fillers.at(1).fraction, 0.1, pi / 8.0 * 0.0049 + 1e-12);
  EXPECT_NEAR(packed.fraction, packed.fillers[0].fraction + packed.fillers[1].fraction, 1e-12);
  EXPECT_NEAR(packed.size_deviation().value(), 0.0, 1e-12);
}

TEST(Fillers, ThatCannotBeDrawnAreNamed) {
  const Filler large = {.material = wax, .fraction = 0.01, .sizes = SingleSize{5e-3}};
  const auto stage = box_with({filler_of(sand, {1e-3}), large});
  EXPECT_THAT(test::message_of<NumericalError>([&] { static_cast<void>(make_microstructure(stage)); }),
              HasSubstr("box: filler 1, wax: "));
}

TEST(Fillers, OfOneMaterialAreOnePhase) {
  const auto coated = [](Filler filler, const Material& material) {
    filler.coating = Coating{material, 0.1e-3};
    return filler;
  };
  const auto glass_disc = filler_of(sand, {1e-3}), steel_disc = filler_of(steel, {1e-3});
  EXPECT_THAT(phase_names(box_with({glass_disc})), ElementsAre("matrix", "filler"));
  EXPECT_THAT(phase_names(box_with({glass_disc, glass_disc})), ElementsAre("matrix", "filler"));
  EXPECT_THAT(phase_names(box_with({steel_disc, glass_disc, steel_disc})), ElementsAre("matrix", "steel", "sand"));
  EXPECT_THAT(phase_names(box_with({coated(glass_disc, wax)})), ElementsAre("matrix", "filler", "wax"));
  EXPECT_THAT(phase_names(box_with({coated(glass_disc, wax), coated(steel_disc, wax)})),
              ElementsAre("matrix", "sand", "steel", "wax"));
  EXPECT_THAT(phase_names(box_with({coated(glass_disc, sand)})), ElementsAre("matrix", "filler"));
  EXPECT_THAT(phase_names(box_with({coated(glass_disc, steel), steel_disc})), ElementsAre("matrix", "sand", "steel"));
}

// Both halves of the box have one particle each: of the phases of the points the steel is on the right.
TEST(Fillers, OfAListHaveTheirMaterials) {
  auto stage = box_with({{.material = sand}, {.material = steel}});
  stage.packing =
      ExplicitPacking<2>{"", std::vector<Disc>{{{2.5e-3, 5e-3}, 4e-3}, {{7.5e-3, 5e-3}, 4e-3}}, Walls::hard, {0, 1}};
  const auto discretisation =
      discretise(stage, *make_microstructure(stage).content<Microstructure<2>>(), 40, Mixing::series);
  EXPECT_EQ(discretisation.cell({10, 20})[0], 1);
  EXPECT_EQ(discretisation.cell({30, 20})[0], 2);
  const auto materials = materials_of(stage, rubber);
  EXPECT_EQ(materials.at(1), sand);
  EXPECT_EQ(materials.at(2), steel);
}

TEST(Fillers, ACoatingOfAListMustNotOverlap) {
  Filler coated = {.material = sand};
  coated.coating = Coating{wax, 0.6e-3};
  auto stage = box_with({coated});
  stage.packing = ExplicitPacking<2>{"", std::vector<Disc>{{{2.5e-3, 5e-3}, 3.5e-3}, {{7e-3, 5e-3}, 3.5e-3}}};
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(make_microstructure(stage)); }),
              HasSubstr("overlap by 0.0002 m"));
}

TEST(Fillers, AreInTheCheckpointOfTheirPacking) {
  const test::TemporaryDirectory directory;
  Checkpoint checkpoint(directory.path() / "packing.checkpoint.h5", {"deck", "1.0"}, {});
  const auto stage = box_with({{.material = sand, .fraction = 0.1, .sizes = SingleSize{1e-3}, .gap = 0.1e-3},
                               filler_of(steel, {2e-3, 1.5e-3}, 0.3e-3)});
  const auto packed = make_microstructure(stage, {}, &checkpoint);
  EXPECT_THAT(checkpoint.look_for_earlier(), IsEmpty());
  const auto again = make_microstructure(
      stage, [](const Progress&) { ADD_FAILURE() << "packs once more"; }, &checkpoint);
  EXPECT_EQ(again.content<Microstructure<2>>()->particles, packed.content<Microstructure<2>>()->particles);
  EXPECT_EQ(again.content<Microstructure<2>>()->fillers, packed.content<Microstructure<2>>()->fillers);
  EXPECT_EQ(again.fillers.at(0).size_deviation, packed.fillers.at(0).size_deviation);
  EXPECT_FALSE(again.fillers.at(1).size_deviation);
}

// The composite has 10 % of steel and 20 % of sand, with 5 % of wax around the sand, in a rubber of 1000 kg/m^3.
TEST(Fillers, AreInTheFillerOfTheWhole) {
  auto coated = filler_of(sand, {1e-3});
  coated.coating = Coating{wax, 0.1e-3};
  const auto study = study_with(box_with({filler_of(steel, {1e-3}), coated}));
  const auto whole =
      filler_of_the_whole(study, study.stages[0], {{{.fraction = 0.1}, {.fraction = 0.2, .coating_fraction = 0.05}}});
  const double density = 780.0 + 400.0 + 45.0 + 650.0;
  EXPECT_NEAR(whole.fraction, 0.3, 1e-15);
  EXPECT_NEAR(whole.mass_fraction, 1180.0 / density, 1e-15);
  ASSERT_EQ(whole.materials.size(), 2U);
  EXPECT_NEAR(whole.materials[0].mass_fraction, 780.0 / density, 1e-15);
  ASSERT_EQ(whole.coatings.size(), 1U);
  EXPECT_EQ(whole.coatings[0].material, "wax");
  EXPECT_NEAR(whole.coatings[0].fraction, 0.05, 1e-15);
  EXPECT_EQ(
      in_words(whole),
      "filler of the whole: 30.0 % by volume, 62.9 % by mass (steel 41.6 %, sand 21.3 %); coatings by mass: wax 2.4 %");
}

}  // namespace
}  // namespace breccia
