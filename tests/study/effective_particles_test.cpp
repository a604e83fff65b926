#include "study/effective_particles.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/microstructure/draw_diameters.hpp"

#include "study/filler_sizes.hpp"
#include "study/stages_of_fillers.hpp"

namespace breccia {
namespace {

using test::filler_of;
using test::stage_with;

TEST(EffectiveParticles, OfOneSizeAreAllOfThem) {
  const auto found = effective_particles_of(stage_with<3>({filler_of(SingleSize{2.0}, 0.25)})).value();
  EXPECT_NEAR(found.share, 1.0, 1e-12);
  EXPECT_NEAR(found.volume, 4.0 / 3.0 * std::numbers::pi / 0.25, 1e-9);
}

// A share a of the volume in discs of area A and the rest in those of area B: (sum V)^2 / sum V^2 of n_A = a / A and
// n_B = (1 - a) / B discs for each unit of the volume.
TEST(EffectiveParticles, OfTwoSizesFollowByHand) {
  const auto found =
      effective_particles_of(stage_with<2>({filler_of(SingleSize{1.0}, 0.1), filler_of(SingleSize{10.0}, 0.4)}))
          .value();
  const double small = std::numbers::pi / 4.0, large = 100.0 * small;
  const double number = 0.1 / small + 0.4 / large, effective = 0.5 * 0.5 / (0.1 * small + 0.4 * large);
  EXPECT_NEAR(found.share, effective / number, 1e-12);
  EXPECT_NEAR(found.volume, 1.0 / effective, 1e-9);
}

/// The effective number of the diameters drawn for a large box, over their number and over the volume of the box.
template <int dim>
EffectiveParticles drawn(const Filler& filler, double side) {
  const auto diameters = draw_diameters<dim>(distribution_of(filler).value(), filler.fraction.value(), side);
  double sum = 0.0, squares = 0.0;
  for (const double diameter : diameters) {
    sum += std::pow(diameter, dim);
    squares += std::pow(diameter, 2 * dim);
  }
  const double effective = sum * sum / squares;
  return {effective / static_cast<double>(diameters.size()), std::pow(side, dim) / effective};
}

TEST(EffectiveParticles, OfADistributionAreThoseOfALargeBox) {
  auto filler = filler_of(LognormalSizes{{{1.0, 1.0, 0.7}}}, 0.4);
  filler.smallest = 0.3;
  filler.largest = 6.0;
  const auto in_plane = effective_particles_of(stage_with<2>({filler})).value();
  const auto of_plane = drawn<2>(filler, 250.0);
  EXPECT_NEAR(in_plane.share / of_plane.share, 1.0, 0.01);
  EXPECT_NEAR(in_plane.volume / of_plane.volume, 1.0, 0.01);
  const auto in_space = effective_particles_of(stage_with<3>({filler})).value();
  const auto of_space = drawn<3>(filler, 40.0);
  EXPECT_NEAR(in_space.share / of_space.share, 1.0, 0.03);
  EXPECT_NEAR(in_space.volume / of_space.volume, 1.0, 0.03);
}

TEST(EffectiveParticles, AreNotKnownOfListsAndWithoutAFraction) {
  auto filler = filler_of(SingleSize{2.0}, 0.25);
  filler.fraction.reset();
  EXPECT_FALSE(effective_particles_of(stage_with<3>({filler})));
  EXPECT_FALSE(effective_particles_of(stage_with<3>({filler_of(ListedSizes{{1.0, 2.0}}, 0.25)})));
  EXPECT_FALSE(effective_particles_of(stage_with<2>({})));
}

}  // namespace
}  // namespace breccia
