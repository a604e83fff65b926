#include "discretisation/mixture_rule.hpp"

#include <array>
#include <complex>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

const Mixture mixture = {{0, 0.25}, {2, 0.75}};

TEST(MixtureRule, InSeriesItsCompliancesAddUp) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  const auto in_space = MixtureRule(mixture).moduli<3>(moduli),
             in_plane_strain = MixtureRule(mixture).moduli<2>(moduli);
  EXPECT_DOUBLE_EQ(in_space.bulk, 1.0 / (0.25 / 4.0 + 0.75 / 3.0));
  EXPECT_DOUBLE_EQ(in_space.shear, 1.0 / (0.25 / 1.0 + 0.75 / 30.0));
  EXPECT_DOUBLE_EQ(in_plane_strain.shear, in_space.shear);
  EXPECT_DOUBLE_EQ(in_plane_strain.bulk + in_plane_strain.shear / 3.0,
                   1.0 / (0.25 / (4.0 + 1.0 / 3.0) + 0.75 / (3.0 + 30.0 / 3.0)));
}

TEST(MixtureRule, WithALiquidHasNoShearModulus) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 0.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  EXPECT_EQ(MixtureRule(mixture).moduli<2>(moduli).shear, 0.0);
  EXPECT_GT(MixtureRule(mixture).moduli<2>(moduli).bulk, 0.0);
}

// The correspondence principle: the complex moduli are mixed like elastic ones.
TEST(MixtureRule, OfRelaxingPhasesIsASeriesMixtureAtEveryFrequency) {
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
TEST(MixtureRule, OfACompositeWhoseBulkModulusRises) {
  const PronySeries shear(1e6, {{1e-3, 9e8}});
  const auto rising = PronySeries::difference(PronySeries(8e9), shear.scaled(1.0 / 3.0));
  const std::array<Material, 3> materials = {{{"composite", 1000.0, rising, shear},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), PronySeries(6e9)}}};
  const auto dilatational = plane_strain_bulk_modulus(MixtureRule(mixture, materials).material<2>(materials));
  for (const double time : {0.0, 1e-4, 1.0}) EXPECT_NEAR(dilatational.at(time), 1.0 / (0.25 / 8e9 + 0.75 / 15e9), 1.0);
}

TEST(MixtureRule, OfADilatationalModulusThatRisesIsRefused) {
  const auto rising = PronySeries::difference(PronySeries(8e9), PronySeries(0.0, {{1e-3, 1e8}}));
  const std::array<Material, 3> materials = {{{"strange", 1000.0, rising, PronySeries(1e6)},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), PronySeries(6e9)}}};
  EXPECT_THROW((void)MixtureRule(mixture, materials).material<2>(materials), InputError);
}

TEST(MixtureRule, OfOneMaterialIsThatMaterial) {
  const Material polymer = {"polymer", 1000.0, PronySeries(2e9), PronySeries(1e6, {{1e-2, 1e7}, {1e-5, 1e8}})};
  const std::array<Material, 3> materials = {polymer, polymer, polymer};
  const auto material = MixtureRule(mixture, materials).material<2>(materials);
  for (const double time : {0.0, 1e-6, 1e-4, 1e-2, 1.0}) {
    EXPECT_NEAR(material.shear.at(time) / polymer.shear.at(time), 1.0, 1e-12);
  }
}

// Eq. 40a of the theory: with a constraint c, 1 / (M + c) is the mean of the 1 / (m_k + c).
double held(double outer, double inner, double share_of_outer, double constraint) {
  return 1.0 / (share_of_outer / (outer + constraint) + (1.0 - share_of_outer) / (inner + constraint)) - constraint;
}

TEST(MixtureRule, LetsTheMatrixHoldASofterPhase) {
  const std::array<Material, 3> materials = {{{"stiff", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(0.1)},
                                              {"soft", 1800.0, PronySeries(3.0), PronySeries(0.01)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {}, {.bulk = 3.0, .shear = 0.01}}};
  const MixtureRule rule(mixture, materials);
  EXPECT_TRUE(rule.is_held());
  const auto in_space = rule.moduli<3>(moduli), in_plane_strain = rule.moduli<2>(moduli);
  EXPECT_NEAR(in_space.bulk, held(4.0, 3.0, 0.25, 3.0), 1e-14);
  EXPECT_NEAR(in_space.shear, held(1.0, 0.01, 0.25, 10.0), 1e-14);
  EXPECT_NEAR(in_plane_strain.bulk + in_plane_strain.shear / 3.0, held(4.0 + 1.0 / 3.0, 3.0 + 0.01 / 3.0, 0.25, 3.0),
              1e-14);
  // Nearly that of the phases in parallel, of which series would leave a fiftieth.
  EXPECT_NEAR(in_space.shear, 0.25 * 1.0 + 0.75 * 0.01, 0.02);
}

TEST(MixtureRule, WithAVoidKeepsAPartOfItsModuli) {
  const std::array<Material, 2> materials = {
      {{"solid", 1000.0, PronySeries(4.0), PronySeries(1.0)}, {"void", 0.0, PronySeries(0.0), PronySeries(0.0)}}};
  const std::array<Moduli, 2> moduli = {{{.bulk = 4.0, .shear = 1.0}, {.bulk = 0.0, .shear = 0.0}}};
  const auto half = MixtureRule({{0, 0.5}, {1, 0.5}}, materials).moduli<3>(moduli);
  EXPECT_NEAR(half.shear, held(1.0, 0.0, 0.5, 10.0), 1e-14);
  EXPECT_NEAR(half.bulk, held(4.0, 0.0, 0.5, 3.0), 1e-14);
}

// A phase holds only what is softer at all times: a filler may be softer than a glassy binder and stiffer later.
TEST(MixtureRule, IsInSeriesWhereTheModuliCross) {
  const PronySeries glass_to_rubber(1e6, {{1e-3, 1e9}});
  const auto holds = [&](const PronySeries& outer, const PronySeries& inner) {
    const std::array<Material, 2> materials = {
        {{"outer", 1000.0, PronySeries(3e9), outer}, {"inner", 1000.0, PronySeries(3e9), inner}}};
    return MixtureRule({{0, 0.5}, {1, 0.5}}, materials).is_held();
  };
  EXPECT_FALSE(holds(glass_to_rubber, PronySeries(1e7)));
  EXPECT_TRUE(holds(glass_to_rubber, PronySeries(0.9e6)));
  EXPECT_TRUE(holds(glass_to_rubber, PronySeries(0.5e6, {{1e-3, 1e8}})));
  EXPECT_FALSE(holds(glass_to_rubber, PronySeries(0.5e6, {{1.0, 1e8}})));  // softer at the ends, stiffer between them
  EXPECT_FALSE(holds(glass_to_rubber, glass_to_rubber));
  EXPECT_FALSE(holds(PronySeries(1.0, {{1e-3, 100.0}}), PronySeries(0.0, {{1.0, 1.5}})));  // stiffer at 10 ms alone
}

// Each is held by itself, in any order of the phases.
TEST(MixtureRule, LetsTheMatrixHoldTwoSofterPhases) {
  const std::array<Material, 3> materials = {{{"matrix", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"soft", 2500.0, PronySeries(2.0), PronySeries(0.2)},
                                              {"softer", 1.0, PronySeries(1.0), PronySeries(0.1)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {2.0, 0.2}, {1.0, 0.1}}};
  const double expected = 1.0 / (0.5 / (1.0 + 10.0) + 0.125 / (0.2 + 10.0) + 0.375 / (0.1 + 10.0)) - 10.0;
  const Mixture parts = {{0, 0.5}, {1, 0.125}, {2, 0.375}}, others = {{2, 0.375}, {1, 0.125}, {0, 0.5}};
  EXPECT_NEAR(MixtureRule(parts, materials).moduli<3>(moduli).shear, expected, 1e-14);
  EXPECT_NEAR(MixtureRule(others, materials).moduli<3>(moduli).shear, expected, 1e-14);
}

// A soft coating of a stiff particle passes on the load of the particle: it is a layer, which is in series.
TEST(MixtureRule, BesideAStiffPhaseIsSeries) {
  const std::array<Material, 3> materials = {{{"matrix", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"particle", 2500.0, PronySeries(50.0), PronySeries(30.0)},
                                              {"coating", 1.0, PronySeries(3.0), PronySeries(0.01)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {50.0, 30.0}, {3.0, 0.01}}};
  EXPECT_DOUBLE_EQ(MixtureRule({{0, 0.5}, {2, 0.5}}, materials).moduli<3>(moduli).shear,
                   1.0 / (0.5 / 1.0 + 0.5 / 0.01));
}

TEST(MixtureRule, WithoutAMatrixIsSeries) {
  const std::array<Material, 3> materials = {{{"matrix", 1000.0, PronySeries(4.0), PronySeries(1.0)},
                                              {"soft", 2500.0, PronySeries(3.0), PronySeries(0.5)},
                                              {"softer", 1.0, PronySeries(3.0), PronySeries(0.01)}}};
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {3.0, 0.5}, {3.0, 0.01}}};
  EXPECT_DOUBLE_EQ(MixtureRule({{1, 0.5}, {2, 0.5}}, materials).moduli<3>(moduli).shear,
                   1.0 / (0.5 / 0.5 + 0.5 / 0.01));
}

/// The correspondence principle: the material has the moduli of the rule at every frequency, in the plane and in space.
/// The matrix holds the two other phases.
void expect_correspondence(const Material& matrix, const Material& one, const Material& other) {
  const std::array<Material, 3> materials = {matrix, one, other};
  const MixtureRule rule({{0, 0.25}, {1, 0.5}, {2, 0.25}}, materials);
  ASSERT_TRUE(rule.is_held());
  const auto in_plane_strain = rule.material<2>(materials), in_space = rule.material<3>(materials);
  const auto off = [](std::complex<double> one, std::complex<double> other) { return std::abs(one / other - 1.0); };
  for (const double omega : {1e-1, 1e1, 1e2, 1e3, 1e4, 1e6}) {
    std::array<std::complex<double>, 3> g, k, kappa;
    for (std::size_t i = 0; i < g.size(); ++i) {
      g[i] = materials[i].shear.complex_modulus(omega);
      k[i] = materials[i].bulk.complex_modulus(omega);
      kappa[i] = k[i] + g[i] / 3.0;
    }
    const auto expected = [&](const auto& m, double of_unit_shear) {
      const auto c = of_unit_shear * g[0];
      return 1.0 / (0.25 / (m[0] + c) + 0.5 / (m[1] + c) + 0.25 / (m[2] + c)) - c;
    };
    EXPECT_LT(off(in_space.shear.complex_modulus(omega), expected(g, 10.0)), 1e-7) << omega << " rad/s";
    EXPECT_LT(off(in_space.bulk.complex_modulus(omega), expected(k, 3.0)), 1e-7) << omega << " rad/s";
    EXPECT_LT(off(plane_strain_bulk_modulus(in_plane_strain).complex_modulus(omega), expected(kappa, 3.0)), 1e-7)
        << omega << " rad/s";
  }
}

TEST(MixtureRule, OfRelaxingPhasesHoldsAtEveryFrequency) {
  const PronySeries binder(1e6, {{1e-2, 1e7}, {1e-4, 300e6}}), soft(1e5, {{1e-3, 1e5}}), other(4e5, {{2e-3, 3e5}});
  expect_correspondence({"binder", 1000.0, PronySeries(3.6e9), binder}, {"other", 1200.0, PronySeries(5e9), other},
                        {"soft", 900.0, PronySeries(2e9), soft});
}

// Series of one master curve: their times are equal, or differ by rounding.
TEST(MixtureRule, OfPhasesWithTheTimesOfTheMatrixHoldsAtEveryFrequency) {
  const PronySeries binder(1e6, {{1e-2, 1e7}, {1e-3, 4e7}, {1e-4, 300e6}});
  const Material matrix = {"binder", 1000.0, PronySeries(3.6e9, {{1e-3, 1e8}}), binder};
  const Material one = {"one", 1200.0, PronySeries(3e9), binder.scaled(0.5)};
  expect_correspondence(matrix, one, {"soft", 900.0, PronySeries(2e9), binder.scaled(0.1)});
  const auto off_by_rounding = binder.scaled(0.1).shifted(1.0 + 1e-15);
  expect_correspondence(matrix, one, {"soft", 900.0, PronySeries(2e9, {{1e-3 * (1.0 + 1e-15), 1e7}}), off_by_rounding});
}

TEST(MixtureRule, OfAVoidHoldsAtEveryFrequency) {
  const PronySeries binder(1e6, {{1e-2, 1e7}, {1e-4, 300e6}});
  expect_correspondence({"binder", 1000.0, PronySeries(3.6e9), binder},
                        {"soft", 1200.0, PronySeries(5e9), PronySeries(3e5)},
                        {"void", 1.0, PronySeries(1.0), PronySeries(1e-3)});
}

}  // namespace
}  // namespace breccia
