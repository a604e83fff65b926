#include "breccia/discretisation/mixture.hpp"

#include <array>
#include <complex>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

const Mixture mixture = {{0, 0.25}, {2, 0.75}};

TEST(Mixture, InSeriesItsCompliancesAddUp) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 1.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  const auto in_space = series_moduli<3>(mixture, moduli), in_plane_strain = series_moduli<2>(mixture, moduli);
  EXPECT_DOUBLE_EQ(in_space.bulk, 1.0 / (0.25 / 4.0 + 0.75 / 3.0));
  EXPECT_DOUBLE_EQ(in_space.shear, 1.0 / (0.25 / 1.0 + 0.75 / 30.0));
  EXPECT_DOUBLE_EQ(in_plane_strain.shear, in_space.shear);
  EXPECT_DOUBLE_EQ(in_plane_strain.bulk + in_plane_strain.shear / 3.0,
                   1.0 / (0.25 / (4.0 + 1.0 / 3.0) + 0.75 / (3.0 + 30.0 / 3.0)));
}

TEST(Mixture, WithALiquidHasNoShearModulus) {
  const std::array<Moduli, 3> moduli = {{{.bulk = 4.0, .shear = 0.0}, {}, {.bulk = 3.0, .shear = 30.0}}};
  EXPECT_EQ(series_moduli<2>(mixture, moduli).shear, 0.0);
  EXPECT_GT(series_moduli<2>(mixture, moduli).bulk, 0.0);
}

// The correspondence principle: the complex moduli are mixed like elastic ones.
TEST(Mixture, OfRelaxingPhasesIsASeriesMixtureAtEveryFrequency) {
  const PronySeries relaxing(0.2e6, {{1e-2, 1e6}, {1e-4, 30e6}}), other(1e6, {{1e-3, 5e6}});
  const std::array<Material, 3> materials = {{{"binder", 1000.0, PronySeries(3.6e9, {{1e-3, 1e8}}), relaxing},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), other}}};
  const auto material = series_material<2>(mixture, materials);
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
  const auto dilatational = plane_strain_bulk_modulus(series_material<2>(mixture, materials));
  for (const double time : {0.0, 1e-4, 1.0}) EXPECT_NEAR(dilatational.at(time), 1.0 / (0.25 / 8e9 + 0.75 / 15e9), 1.0);
}

TEST(Mixture, OfADilatationalModulusThatRisesIsRefused) {
  const auto rising = PronySeries::difference(PronySeries(8e9), PronySeries(0.0, {{1e-3, 1e8}}));
  const std::array<Material, 3> materials = {{{"strange", 1000.0, rising, PronySeries(1e6)},
                                              {"unused", 1.0, PronySeries(1.0), PronySeries(1.0)},
                                              {"filler", 1800.0, PronySeries(13e9), PronySeries(6e9)}}};
  EXPECT_THROW((void)series_material<2>(mixture, materials), InputError);
}

TEST(Mixture, OfOneMaterialIsThatMaterial) {
  const Material polymer = {"polymer", 1000.0, PronySeries(2e9), PronySeries(1e6, {{1e-2, 1e7}, {1e-5, 1e8}})};
  const std::array<Material, 3> materials = {polymer, polymer, polymer};
  const auto material = series_material<2>(mixture, materials);
  for (const double time : {0.0, 1e-6, 1e-4, 1e-2, 1.0}) {
    EXPECT_NEAR(material.shear.at(time) / polymer.shear.at(time), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace breccia
