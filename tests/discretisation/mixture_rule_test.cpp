#include "discretisation/mixture_rule.hpp"

#include <array>
#include <complex>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

const Mixture mixture = {{0, 0.25}, {2, 0.75}};

TEST(Mixture, InSeriesItsCompliancesAddUp) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  const auto in_space = MixtureRule(mixture).moduli<3>(moduli),
             in_plane_strain = MixtureRule(mixture).moduli<2>(moduli);
  EXPECT_DOUBLE_EQ(in_space.bulk, 1.0 / (0.25 / 4.0 + 0.75 / 3.0));
  EXPECT_DOUBLE_EQ(in_space.shear, 1.0 / (0.25 / 1.0 + 0.75 / 30.0));
  EXPECT_DOUBLE_EQ(in_plane_strain.shear, in_space.shear);
  EXPECT_DOUBLE_EQ(in_plane_strain.bulk + in_plane_strain.shear / 3.0,
                   1.0 / (0.25 / (4.0 + 1.0 / 3.0) + 0.75 / (3.0 + 30.0 / 3.0)));
}

TEST(Mixture, WithALiquidHasNoShearModulus) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 0.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  EXPECT_EQ(MixtureRule(mixture).moduli<2>(moduli).shear, 0.0);
  EXPECT_GT(MixtureRule(mixture).moduli<2>(moduli).bulk, 0.0);
}

// The correspondence principle: the complex moduli are mixed like elastic ones.
TEST(Mixture, OfRelaxingPhasesIsASeriesMixtureAtEveryFrequency) {
  const PronySeries relaxing(0.2e6, {{1e-2, 1e6}, {1e-4, 30e6}}), other(1e6, {{1e-3, 5e6}});
  const std::array<Material, 3> materials = {{{"binder", 1000.0, PronySeries(3.6e9, {{1e-3, 1e8}}), relaxing},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), other}}};
  const auto material = MixtureRule(mixture, materials).material<2>(materials);
  EXPECT_DOUBLE_EQ(material.density, 0.25 * 1000.0 + 0.75 * 1800.0);
  for (const double omega : {1e-1, 1e1, 1e2, 1e3, 1e4, 1e6}) {
    const auto expected = 1.0 / (0.25 / relaxing.complex_modulus(omega) + 0.75 / other.complex_modulus(omega));
    EXPECT_LT(std::abs(material.shear.complex_modulus(omega) / expected - 1.0), 1e-12) << omega << " rad/s";
    const auto dilatational_of = [&](const Material& one) {
      return one.bulk.complex_modulus(omega) + one.shear.complex_modulus(omega) / 3.0;
    };
    const auto dilatational = 1.0 / (0.25 / dilatational_of(materials[0]) + 0.75 / dilatational_of(materials[2]));
    EXPECT_LT(std::abs(dilatational_of(material) / dilatational - 1.0), 1e-12) << omega << " rad/s";
  }
  // There is one term for each relaxation time of its phases.
  EXPECT_EQ(material.shear.terms().size(), 3U);
}

// The bulk modulus K of a composite may rise in plane strain; K + G/3 falls.
TEST(Mixture, OfACompositeWhoseBulkModulusRises) {
  const PronySeries shear(1e6, {{1e-3, 9e8}});
  const auto rising = PronySeries::difference(PronySeries(8e9), shear.scaled(1.0 / 3.0));
  const std::array<Material, 3> materials = {{{"composite", 1000.0, rising, shear},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), PronySeries(6e9)}}};
  const auto dilatational = plane_strain_bulk_modulus(MixtureRule(mixture, materials).material<2>(materials));
  for (const double time : {0.0, 1e-4, 1.0}) EXPECT_NEAR(dilatational.at(time), 1.0 / (0.25 / 8e9 + 0.75 / 15e9), 1.0);
}

TEST(Mixture, OfADilatationalModulusThatRisesIsRefused) {
  const auto rising = PronySeries::difference(PronySeries(8e9), PronySeries(0.0, {{1e-3, 1e8}}));
  const std::array<Material, 3> materials = {{{"strange", 1000.0, rising, PronySeries(1e6)},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), PronySeries(6e9)}}};
  EXPECT_THROW((void)MixtureRule(mixture, materials).material<2>(materials), InputError);
}

TEST(Mixture, OfOneMaterialIsThatMaterial) {
  const Material polymer = {"polymer", 1000.0, PronySeries(2e9), PronySeries(1e6, {{1e-2, 1e7}, {1e-5, 1e8}})};
  const std::array<Material, 3> materials = {polymer, polymer, polymer};
  const auto material = MixtureRule(mixture, materials).material<2>(materials);
  for (const double time : {0.0, 1e-6, 1e-4, 1e-2, 1.0}) {
    EXPECT_NEAR(material.shear.at(time) / polymer.shear.at(time), 1.0, 1e-12);
  }
}

// Eq. 40a of the theory: with a constraint c, 1 / (M + c) is the mean of the 1 / (M_k + c).
double held(double outer, double inner, double share_of_outer, double constraint) {
  return 1.0 / (share_of_outer / (outer + constraint) + (1.0 - share_of_outer) / (inner + constraint)) - constraint;
}

TEST(Mixture, IsHeldByAStifferPhaseAroundSofterOnes) {
  const std::array<Material, 3> materials = {{{"stiff", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"soft", 1800.0, PronySeries(3.0), PronySeries(0.01)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {}, {.bulk = 3.0, .shear = 0.01}}};
  const MixtureRule rule(mixture, materials);
  EXPECT_TRUE(rule.holds(0));
  EXPECT_FALSE(rule.holds(1));
  const auto in_space = rule.moduli<3>(moduli), in_plane_strain = rule.moduli<2>(moduli);
  EXPECT_NEAR(in_space.bulk, held(4.0, 3.0, 0.25, 3.0), 1e-14);
  EXPECT_NEAR(in_space.shear, held(1.0, 0.01, 0.25, 10.0), 1e-14);
  EXPECT_NEAR(in_plane_strain.bulk + in_plane_strain.shear / 3.0, held(4.0 + 1.0 / 3.0, 3.0 + 0.01 / 3.0, 0.25, 3.0),
              1e-14);
  // Nearly that of the phases in parallel, of which series would leave a fiftieth.
  EXPECT_NEAR(in_space.shear, 0.25 * 1.0 + 0.75 * 0.01, 0.02);
}

TEST(Mixture, WithAVoidKeepsAPartOfItsModuli) {
  const std::array<Material, 2> materials = {
      {{"solid", 1000.0, PronySeries(4.0), PronySeries(1.0)}, {"void", 0.0, PronySeries(0.0), PronySeries(0.0)}}};
  const std::array<Moduli, 2> moduli = {{{.bulk = 4.0, .shear = 1.0}, {.bulk = 0.0, .shear = 0.0}}};
  const auto half = MixtureRule({{0, 0.5}, {1, 0.5}}, materials).moduli<3>(moduli);
  EXPECT_NEAR(half.shear, held(1.0, 0.0, 0.5, 10.0), 1e-14);
  EXPECT_NEAR(half.bulk, held(4.0, 0.0, 0.5, 3.0), 1e-14);
}

// A phase holds only what is softer at all times: a filler may be softer than a glassy binder and stiffer later.
TEST(Mixture, IsInSeriesWhereTheModuliCross) {
  const PronySeries glass_to_rubber(1e6, {{1e-3, 1e9}});
  const auto holds = [&](const PronySeries& outer, const PronySeries& inner) {
    const std::array<Material, 2> materials = {
        {{"outer", 1000.0, PronySeries(3e9), outer}, {"inner", 1000.0, PronySeries(3e9), inner}}};
    return MixtureRule({{0, 0.5}, {1, 0.5}}, materials).holds(0);
  };
  EXPECT_FALSE(holds(glass_to_rubber, PronySeries(1e7)));
  EXPECT_TRUE(holds(glass_to_rubber, PronySeries(0.9e6)));
  EXPECT_TRUE(holds(glass_to_rubber, PronySeries(0.5e6, {{1e-3, 1e8}})));
  EXPECT_FALSE(holds(glass_to_rubber, PronySeries(0.5e6, {{1.0, 1e8}})));  // softer at the ends, stiffer between them
  EXPECT_FALSE(holds(glass_to_rubber, glass_to_rubber));
}

// A hollow sphere in a binder: its shell holds the void, and both are in series with the softer binder.
TEST(Mixture, OfThreePhasesGoesFromTheInsideOutwards) {
  const std::array<Material, 3> materials = {{{"binder", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"shell", 2500.0, PronySeries(50.0), PronySeries(30.0)},
                                              {"gas", 1.0, PronySeries(1e-4), PronySeries(0.0)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {50.0, 30.0}, {1e-4, 0.0}}};
  const MixtureRule rule({{0, 0.5}, {1, 0.125}, {2, 0.375}}, materials);
  EXPECT_FALSE(rule.holds(0));
  EXPECT_TRUE(rule.holds(1));
  const double particle = held(30.0, 0.0, 0.25, 300.0);
  EXPECT_NEAR(rule.moduli<3>(moduli).shear, 1.0 / (0.5 / 1.0 + 0.5 / particle), 1e-13);
}

// The correspondence principle, for a soft filler in a binder that relaxes, and with a shell around it.
TEST(Mixture, OfRelaxingPhasesIsHeldAtEveryFrequency) {
  const PronySeries binder(1e6, {{1e-2, 1e7}, {1e-4, 300e6}}), soft(1e5, {{1e-3, 1e5}}), shell(1e9, {{1e-2, 1e9}});
  const std::array<Material, 3> materials = {{{"binder", 1000.0, PronySeries(3.6e9), binder},
                                              {"shell", 1200.0, PronySeries(5e9), shell},
                                              {"soft", 900.0, PronySeries(2e9), soft}}};
  const auto held_at = [](std::complex<double> outer, std::complex<double> inner, double share,
                          std::complex<double> constraint) {
    return 1.0 / (share / (outer + constraint) + (1.0 - share) / (inner + constraint)) - constraint;
  };
  const auto of_two = MixtureRule({{0, 0.25}, {2, 0.75}}, materials).material<3>(materials);
  const auto of_three = MixtureRule({{0, 0.5}, {1, 0.125}, {2, 0.375}}, materials).material<3>(materials);
  for (const double omega : {1e-1, 1e1, 1e2, 1e3, 1e4, 1e6}) {
    const auto g = binder.complex_modulus(omega), in_shell = shell.complex_modulus(omega);
    const auto expected = held_at(g, soft.complex_modulus(omega), 0.25, 10.0 * g);
    EXPECT_LT(std::abs(of_two.shear.complex_modulus(omega) / expected - 1.0), 1e-9) << omega << " rad/s";
    const auto bulk = held_at(3.6e9, 2e9, 0.25, 3.0 * g);
    EXPECT_LT(std::abs(of_two.bulk.complex_modulus(omega) / bulk - 1.0), 1e-9) << omega << " rad/s";
    const auto particle = held_at(in_shell, soft.complex_modulus(omega), 0.25, 10.0 * in_shell);
    EXPECT_LT(std::abs(of_three.shear.complex_modulus(omega) * (0.5 / g + 0.5 / particle) - 1.0), 1e-9)
        << omega << " rad/s";
  }
}

}  // namespace
}  // namespace breccia
