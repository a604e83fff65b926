#include "study/side_of_particles.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

#include "messages.hpp"
#include "study/filler_sizes.hpp"
#include "study/stages_of_fillers.hpp"

namespace breccia {
namespace {

using test::filler_of;
using test::message_of;
using test::stage_with;
using testing::HasSubstr;

Filler lognormal(double median, double fraction) {
  auto filler = filler_of(LognormalSizes{{{1.0, median, 0.5}}}, fraction);
  filler.smallest = 0.4 * median;
  filler.largest = 2.5 * median;
  return filler;
}

/// The particles that are drawn for a box of this side and the fraction that they fill.
template <int dim>
std::pair<std::size_t, double> drawn(const Stage& stage, double side) {
  std::size_t count = 0;
  double volume = 0.0;
  for (const auto& filler : stage.fillers) {
    const auto diameters = draw_diameters<dim>(distribution_of(filler).value(), filler.fraction.value(), side);
    count += diameters.size();
    for (const double diameter : diameters) volume += ball_volume<dim>(diameter);
  }
  return {count, volume / std::pow(side, dim)};
}

TEST(SideOfParticles, OfOneSizeIsThatOfTheirVolume) {
  const auto discs = stage_with<2>({filler_of(SingleSize{2e-3}, 0.5)});
  EXPECT_NEAR(side_of_particles(discs, 64), std::sqrt(64.0 * std::numbers::pi / 0.5) * 1e-3, 1e-7);
  const auto spheres = stage_with<3>({filler_of(SingleSize{2e-3}, 0.4)});
  EXPECT_NEAR(side_of_particles(spheres, 20), std::cbrt(20.0 * 4.0 / 3.0 * std::numbers::pi / 0.4) * 1e-3, 1e-7);
}

/// A box of a given side may have a fraction that is off by half of a particle: 20 % become 20.8 %.
template <int dim>
void expect_number_and_fraction(const Stage& stage, double fraction) {
  for (const int particles : {1, 13, 64, 1000}) {
    const auto [count, filled] = drawn<dim>(stage, side_of_particles(stage, particles));
    EXPECT_EQ(count, static_cast<std::size_t>(particles));
    EXPECT_NEAR(filled, fraction, 1e-3 * fraction) << particles;
  }
}

TEST(SideOfParticles, MeetsTheirNumberAndTheirFraction) {
  expect_number_and_fraction<2>(stage_with<2>({filler_of(SingleSize{1e-3}, 0.2)}), 0.2);
  expect_number_and_fraction<2>(stage_with<2>({lognormal(1e-5, 0.45)}), 0.45);
  expect_number_and_fraction<3>(stage_with<3>({lognormal(1e-3, 0.3)}), 0.3);
  expect_number_and_fraction<2>(
      stage_with<2>({filler_of(TabulatedSizes{{}, {1e-4, 2e-4, 8e-4}, {0.0, 0.3, 1.0}}, 0.6)}), 0.6);
}

TEST(SideOfParticles, OfTwoFillersMeetsTheFractionOfBoth) {
  const auto stage = stage_with<2>({filler_of(SingleSize{2e-3}, 0.3), lognormal(5e-4, 0.2)});
  for (const int particles : {50, 200}) {
    const auto [count, filled] = drawn<2>(stage, side_of_particles(stage, particles));
    EXPECT_NEAR(static_cast<double>(count), particles, 0.05 * particles);
    EXPECT_NEAR(filled, 0.5, 1e-3 * 0.5);
  }
}

/// The smallest particles of these sizes have a millionth of the volume of the median one, and less.
TEST(SideOfParticles, OfWideDistributionsIsFound) {
  for (const double smallest : {1e-5, 1e-6, 1e-8}) {
    auto wide = lognormal(1e-3, 0.4);
    wide.smallest = smallest;
    const auto discs = drawn<2>(stage_with<2>({wide}), side_of_particles(stage_with<2>({wide}), 64));
    const auto spheres = drawn<3>(stage_with<3>({wide}), side_of_particles(stage_with<3>({wide}), 64));
    for (const auto& [count, filled] : {discs, spheres}) {
      EXPECT_NEAR(static_cast<double>(count), 64.0, 1.0);
      EXPECT_NEAR(filled, 0.4, 2e-3 * 0.4);
    }
  }
}

TEST(SideOfParticles, HoldsAParticleOfEachFiller) {
  const auto stage = stage_with<2>({filler_of(SingleSize{1e-3}, 0.4), filler_of(SingleSize{5e-3}, 0.05)});
  EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(side_of_particles(stage, 40)); }),
              HasSubstr("40 particles are too few: a box with one of each filler holds 101"));
  EXPECT_EQ(fewest_particles(stage), 101);
  const auto [count, filled] = drawn<2>(stage, side_of_particles(stage, 303));
  EXPECT_NEAR(static_cast<double>(count), 303.0, 101.0) << "a box has whole large particles";
  EXPECT_NEAR(filled, 0.45, 3e-3 * 0.45);
}

TEST(SideOfParticles, BelongsToSizesAndAFraction) {
  const auto listed = stage_with<2>({filler_of(ListedSizes{{1e-3, 2e-3}}, 0.3)});
  EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(side_of_particles(listed, 9)); }),
              HasSubstr("a list has its own"));
  auto without = stage_with<2>({filler_of(SingleSize{1e-3}, 0.3)});
  without.fillers.front().fraction.reset();
  EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(side_of_particles(without, 9)); }),
              HasSubstr("belongs to a fraction"));
}

}  // namespace
}  // namespace breccia
