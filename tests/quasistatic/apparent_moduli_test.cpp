#include "breccia/quasistatic/apparent_moduli.hpp"

#include <array>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr std::array loads = {Load::shear, Load::bulk, Load::diagonal_shear};
const Material stiff = {"stiff", 1.0, PronySeries(7.0), PronySeries(3.0)};

/// A box of 8 x 8 cells with a material in its lower half, another in the upper one.
QuasistaticProblem<2> layers(const Material& lower, const Material& upper, Boundary boundary) {
  QuasistaticProblem<2> problem{
      .discretisation = Discretisation<2>(Grid<2>{{8, 8}, 0.125}), .materials = {lower, upper}, .boundary = boundary};
  problem.discretisation.paint([](const Vector<2>& position) { return position[1] > 0.5; }, 1);
  return problem;
}

// In plane strain the load in bulk measures K + G/3.
TEST(ApparentModuli, OfAHomogeneousBoxAreThoseOfItsMaterial) {
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    const auto moduli = apparent_moduli(layers(stiff, stiff, boundary), loads);
    EXPECT_NEAR(moduli.at(0), 3.0, 1e-8);
    EXPECT_NEAR(moduli.at(1), 8.0, 1e-8);
    EXPECT_NEAR(moduli.at(2), 3.0, 1e-8);
  }
}

// Under a shear along the layers the stress is uniform, and Reuss's modulus is exact.
TEST(ApparentModuli, OfPeriodicLayersInShearAreReusss) {
  const Material soft = {"soft", 1.0, PronySeries(7.0), PronySeries(0.5)};
  const auto moduli = apparent_moduli(layers(soft, stiff, Boundary::periodic), std::array{Load::shear});
  EXPECT_NEAR(moduli.at(0), 2.0 / (1.0 / 0.5 + 1.0 / 3.0), 1e-8);
}

TEST(ApparentModuli, AMaterialThatRelaxesIsRefused) {
  const Material relaxing = {"relaxing", 1.0, PronySeries(7.0), PronySeries(1.0, {{1.0, 2.0}})};
  EXPECT_THROW(static_cast<void>(apparent_moduli(layers(stiff, relaxing, Boundary::periodic), loads)), InputError);
  auto none = layers(stiff, stiff, Boundary::periodic);
  none.materials.clear();
  EXPECT_THROW(static_cast<void>(apparent_moduli(none, loads)), InputError);
}

TEST(ApparentModuli, RefuseWhatIsIncomplete) {
  auto problem = layers(stiff, stiff, Boundary::periodic);
  EXPECT_THROW(static_cast<void>(apparent_moduli(problem, {})), InputError) << "no load";
  problem.materials.pop_back();
  EXPECT_THROW(static_cast<void>(apparent_moduli(problem, loads)), InputError) << "a phase without a material";
}

}  // namespace
}  // namespace breccia
