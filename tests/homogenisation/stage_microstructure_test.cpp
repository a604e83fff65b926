#include "breccia/homogenisation/stage_microstructure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/box/stage_microstructure_state.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using std::numbers::pi;
using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A filler and how it is packed.
struct Particles {
  Filler filler;
  PackingMethod<2> packing;
};

/// A box of 10 mm with 200 cells of 50 um.
Stage box(const std::optional<Particles>& particles = std::nullopt) {
  Stage stage = {.name = "A", .matrix = {}, .side = 10e-3, .cells = 200};
  if (!particles) return stage;
  stage.fillers = {particles->filler};
  stage.packing = particles->packing;
  return stage;
}

Particles regular(double diameter, int columns, int rows) {
  return {Filler{.material = {}, .sizes = SingleSize{diameter}}, RegularPacking{columns, rows}};
}

Particles listed(const std::vector<Disc>& discs) {
  return {Filler{}, ExplicitPacking<2>{"discs.csv", discs}};
}

Particles random(Sizes sizes, std::optional<double> fraction, Walls walls = Walls::hard, std::uint64_t seed = 1) {
  return {Filler{.material = {}, .fraction = fraction, .sizes = std::move(sizes), .gap = 0.15e-3},
          LubachevskyStillingerPacking<2>{walls, seed}};
}

Particles grains(double diameter, double fraction, std::uint64_t seed = 1) {
  return {Filler{.material = {}, .fraction = fraction, .sizes = SingleSize{diameter}},
          LaguerrePacking<2>{.seed = seed}};
}

std::vector<double> diameters(const StageMicrostructure& packed) {
  std::vector<double> all;
  for (const auto& disc : packed.content<Microstructure<2>>()->particles) all.push_back(disc.diameter);
  return all;
}

double largest_area_share(const StageMicrostructure& packed, double fraction) {
  const double largest = std::ranges::max(diameters(packed));
  return pi / 4.0 * largest * largest /
         (fraction * packed.content<Microstructure<2>>()->side * packed.content<Microstructure<2>>()->side);
}

TEST(MakeMicrostructure, EmptyBox) {
  const auto packed = make_microstructure(box());
  EXPECT_EQ(packed.content<Microstructure<2>>()->side, 10e-3);
  EXPECT_THAT(packed.content<Microstructure<2>>()->particles, IsEmpty());
  EXPECT_EQ(packed.fraction, 0.0);
  EXPECT_EQ(packed.interface_per_area, 0.0);
  EXPECT_EQ(packed.gap, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(packed.size_deviation());
}

TEST(MakeMicrostructure, RegularPacking) {
  const auto packed = make_microstructure(box(regular(2e-3, 4, 2)));
  EXPECT_EQ(packed.content<Microstructure<2>>()->particles.size(), 8U);
  EXPECT_THAT(packed.content<Microstructure<2>>()->particles[1].centre,
              ElementsAre(DoubleEq(3.75e-3), DoubleEq(2.5e-3)));
  EXPECT_NEAR(packed.fraction, 8.0 * pi / 100.0, 1e-12);
  EXPECT_NEAR(packed.interface_per_area, 8.0 * pi * 2e-3 / 1e-4, 1e-9);
  EXPECT_NEAR(packed.gap, 0.5e-3, 1e-12);
  EXPECT_EQ(packed.events, 0U);
}

TEST(MakeMicrostructure, ExplicitPackingIsTakenOver) {
  const std::vector<Disc> discs{{{2e-3, 2e-3}, 2e-3}, {{5e-3, 2e-3}, 3e-3}};
  const auto packed = make_microstructure(box(listed(discs)));
  EXPECT_EQ(packed.content<Microstructure<2>>()->particles, discs);
  EXPECT_EQ(packed.content<Microstructure<2>>()->walls, Walls::hard);
  EXPECT_NEAR(packed.fraction, pi / 4.0 * (4.0 + 9.0) / 100.0, 1e-12);
  EXPECT_NEAR(packed.gap, 0.5e-3, 1e-12);
}

TEST(MakeMicrostructure, ExplicitDiscsMustNotOverlap) {
  const auto stage = box(listed({{{2e-3, 2e-3}, 2e-3}, {{3e-3, 2e-3}, 2e-3}}));
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(make_microstructure(stage)); }),
              HasSubstr("overlap by 0.001 m"));
}

TEST(MakeMicrostructure, ExplicitDiscsGoOnBeyondTheSidesOfAPeriodicBox) {
  auto filler = listed({{{0.5e-3, 5e-3}, 2e-3}, {{8e-3, 5e-3}, 2e-3}});
  std::get<ExplicitPacking<2>>(filler.packing).walls = Walls::periodic;
  const auto packed = make_microstructure(box(filler));
  EXPECT_EQ(packed.content<Microstructure<2>>()->walls, Walls::periodic);
  EXPECT_NEAR(packed.gap, 0.5e-3, 1e-12) << "across the side";
  EXPECT_NEAR(packed.fraction, 2.0 * pi / 100.0, 1e-12);
  EXPECT_EQ(packed.wall_gap, std::numeric_limits<double>::infinity());
}

TEST(MakeMicrostructure, ListedSizesArePackedUnchanged) {
  const std::vector<double> sizes{3e-3, 1e-3, 2e-3, 1e-3};
  const auto packed = make_microstructure(box(random(ListedSizes{sizes}, std::nullopt)));
  EXPECT_THAT(diameters(packed), testing::UnorderedElementsAreArray(sizes));
  EXPECT_NEAR(packed.fraction, pi / 4.0 * (9.0 + 1.0 + 4.0 + 1.0) / 100.0, 1e-12);
  EXPECT_GE(packed.gap, 0.15e-3);
  EXPECT_FALSE(packed.size_deviation());
  EXPECT_GT(packed.events, 0U);
}

TEST(MakeMicrostructure, OneSizeFillsTheFractionWithinOneParticle) {
  const auto packed = make_microstructure(box(random(SingleSize{1e-3}, 0.5)));
  EXPECT_THAT(diameters(packed), testing::Each(1e-3));
  EXPECT_NEAR(packed.fraction, 0.5, pi / 4.0 / 100.0);
  EXPECT_NEAR(packed.size_deviation().value(), 0.0, 1e-12);
}

TEST(MakeMicrostructure, DistributionsAreMetWithinOneParticle) {
  auto lognormal = random(LognormalSizes{{{0.7, 1e-3, 0.5}, {0.3, 0.5e-3, 0.3}}}, 0.5);
  lognormal.filler.smallest = 0.3e-3;
  lognormal.filler.largest = 2e-3;
  auto table =
      random(TabulatedSizes{"sizes.csv", {0.2e-3, 0.5e-3, 1e-3, 3e-3}, {0.0, 0.2, 0.6, 1.0}}, 0.5, Walls::periodic);
  table.filler.smallest = 0.3e-3;
  table.filler.largest = 2e-3;
  for (const auto& filler : {lognormal, table}) {
    const auto packed = make_microstructure(box(filler));
    const double one_particle = largest_area_share(packed, 0.5);
    EXPECT_THAT(diameters(packed), testing::Each(AllOf(testing::Ge(0.3e-3), testing::Le(2e-3))));
    EXPECT_LE(packed.size_deviation().value(), one_particle);
    EXPECT_NEAR(packed.fraction / 0.5, 1.0, one_particle);
    EXPECT_GE(packed.gap, 0.15e-3);
    EXPECT_EQ(packed.content<Microstructure<2>>()->walls,
              std::get<LubachevskyStillingerPacking<2>>(filler.packing).walls);
  }
}

TEST(MakeMicrostructure, TheSeedDecidesWhereParticlesAre) {
  const auto first = make_microstructure(box(random(SingleSize{1e-3}, 0.4)));
  EXPECT_EQ(make_microstructure(box(random(SingleSize{1e-3}, 0.4))).content<Microstructure<2>>()->particles,
            first.content<Microstructure<2>>()->particles);
  EXPECT_NE(
      make_microstructure(box(random(SingleSize{1e-3}, 0.4, Walls::hard, 2))).content<Microstructure<2>>()->particles,
      first.content<Microstructure<2>>()->particles);
}

TEST(MakeMicrostructure, ImpossiblePackingsAreRefused) {
  const auto message = test::message_of<NumericalError>(
      [] { static_cast<void>(make_microstructure(box(random(SingleSize{1e-3}, 0.85)))); });
  EXPECT_THAT(message,
              AllOf(HasSubstr("A: 108 particles of 1 mm at a fraction of 0.85 with a gap of 150 um (3 cells of 50 um)"),
                    HasSubstr("cannot be packed")));
}

/// Packs in a run that is interrupted after each part and resumed. Counts the interruptions.
StageMicrostructure make_bit_by_bit(const Stage& stage, int& interruptions) {
  const test::TemporaryDirectory directory;
  const CheckpointSchedule always_ending = {.stop = [] { return true; }};
  for (interruptions = 0; interruptions < 1000; ++interruptions) {
    Checkpoint checkpoint(directory.path() / "packing.checkpoint.h5", {"deck", "1.0"}, always_ending);
    EXPECT_THAT(checkpoint.look_for_earlier(), IsEmpty());
    try {
      return make_microstructure(stage, {}, &checkpoint);
    } catch (const Interrupted&) {
      EXPECT_THROW(read_stage_microstructure(StateReader(directory.path() / "packing.checkpoint.h5"), stage), FileError)
          << "no discs before the packing is done";
    }
  }
  ADD_FAILURE() << "never done";
  return {};
}

TEST(MakeMicrostructure, ResumesFromAnInterruption) {
  const auto stage = box(random(SingleSize{1e-3}, 0.5));
  const auto whole = make_microstructure(stage);
  int interruptions = 0;
  const auto packed = make_bit_by_bit(stage, interruptions);
  EXPECT_GT(interruptions, 3);
  EXPECT_EQ(packed.content<Microstructure<2>>()->particles, whole.content<Microstructure<2>>()->particles);
  EXPECT_EQ(packed.events, whole.events);
  EXPECT_EQ(packed.size_deviation(), whole.size_deviation());
}

TEST(MakeMicrostructure, TheResultIsInItsCheckpoint) {
  const test::TemporaryDirectory directory;
  Checkpoint checkpoint(directory.path() / "packing.checkpoint.h5", {"deck", "1.0"}, {});
  const auto stage = box(random(SingleSize{1e-3}, 0.5));
  const auto packed = make_microstructure(stage, {}, &checkpoint);
  EXPECT_THAT(checkpoint.look_for_earlier(), IsEmpty());
  const auto again = make_microstructure(
      stage, [](const Progress&) { ADD_FAILURE() << "packs once more"; }, &checkpoint);
  EXPECT_EQ(again.content<Microstructure<2>>()->particles, packed.content<Microstructure<2>>()->particles);
  EXPECT_EQ(again.gap, packed.gap);
}

TEST(Grains, FillTheirFractionOfTheBox) {
  const auto packed = make_microstructure(box(grains(1e-3, 0.93)));
  ASSERT_NE(packed.grains(), nullptr);
  EXPECT_NEAR(packed.fraction, 0.93, 1e-12);
  // The number of grains is that of discs of this size that fill the box.
  EXPECT_EQ(packed.particles(), static_cast<std::size_t>(std::lround(100.0 / (pi / 4.0))));
  EXPECT_EQ(packed.gap, packed.grains()->film);
  EXPECT_EQ(packed.wall_gap, std::numeric_limits<double>::infinity());
  // The area of the films is half a film along all outlines, apart from the corners.
  EXPECT_NEAR(packed.interface_per_area * packed.gap / 2.0, 0.07, 0.003);
  ASSERT_EQ(packed.fillers.size(), 1U);
  EXPECT_NEAR(packed.fillers[0].smallest_diameter.value() / 1e-3, std::sqrt(0.93), 0.02);
  EXPECT_NEAR(packed.fillers[0].largest_diameter.value() / 1e-3, std::sqrt(0.93), 0.02);
}

TEST(Grains, ThatFilmsTakeWhollyAreRefused) {
  auto stage = box(grains(1e-3, 0.93));
  stage.fillers.front().fraction.reset();
  stage.packed_by<LaguerrePacking<2>>()->film = 5e-3;
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(make_microstructure(stage)); }),
              HasSubstr("packing.film: films of 5 mm leave nothing of any grain"));
}

TEST(Grains, OfOneSeedAreTheSame) {
  const auto one = make_microstructure(box(grains(1e-3, 0.93, 1))),
             same = make_microstructure(box(grains(1e-3, 0.93, 1)));
  const auto other = make_microstructure(box(grains(1e-3, 0.93, 2)));
  EXPECT_EQ(one.grains()->film, same.grains()->film);
  EXPECT_NE(one.grains()->film, other.grains()->film);
}

TEST(Grains, AreInTheCellsAsInTheBox) {
  const auto stage = box(grains(2e-3, 0.93));
  const auto packed = make_microstructure(stage);
  EXPECT_NEAR(fractions(discretise(stage, packed, 100, Mixing::series), 2)[1], 0.93, 2e-4);
  EXPECT_NEAR(fractions(discretise(stage, packed, 400, Mixing::points), 2)[1], 0.93, 2e-3);
}

TEST(Grains, AreReadFromTheirState) {
  const test::TemporaryDirectory directory;
  const auto stage = box(grains(2e-3, 0.93));
  const auto packed = make_microstructure(stage);
  {
    StateWriter state(directory.path() / "grains.h5", {"deck", "1.0"});
    save(state, packed);
    state.commit();
  }
  const auto read = read_stage_microstructure(StateReader(directory.path() / "grains.h5"), stage);
  EXPECT_EQ(read.grains()->film, packed.grains()->film);
  EXPECT_EQ(read.fraction, packed.fraction);
  EXPECT_EQ(read.particles(), packed.particles());
}

}  // namespace
}  // namespace breccia
