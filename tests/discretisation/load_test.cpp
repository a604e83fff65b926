#include "breccia/discretisation/load.hpp"

#include <array>

#include <gtest/gtest.h>

#include "breccia/discretisation/crystals.hpp"

namespace breccia {
namespace {

TEST(PairsOfLoads, AreAllPairsOfTheSixThatSpanTheStrains) {
  constexpr std::array spanning = {Load::shear,    Load::diagonal_shear, Load::bulk,
                                   Load::shear_yz, Load::shear_zx,       Load::axial_shear};
  for (const auto one : spanning) {
    EXPECT_FALSE(pair_of(one));
    for (const auto other : spanning) {
      int found = 0;
      for (const auto& pair : pairs_of_loads) {
        found += (pair.one == one && pair.other == other) || (pair.one == other && pair.other == one) ? 1 : 0;
      }
      EXPECT_EQ(found, one == other ? 0 : 1) << name_of(one) << " and " << name_of(other);
      const double product = contraction(unit_strain<3>(one), unit_strain<3>(other));
      if (one != other) {
        EXPECT_NEAR(product, 0.0, 1e-16);
      }
    }
  }
}

TEST(PairsOfLoads, HaveTheSumOfTheirStrains) {
  const auto in_plane = unit_strain<2>(Load::shear_and_bulk);
  EXPECT_EQ(in_plane, (Strain<2>{.xx = 0.5, .yy = 0.5, .xy = 0.5}));
  const auto in_space = unit_strain<3>(Load::bulk_and_shear_yz);
  EXPECT_EQ(in_space, (Strain<3>{.xx = 1.0 / 3.0, .yy = 1.0 / 3.0, .zz = 1.0 / 3.0, .yz = 0.5}));
  EXPECT_EQ(unit_strain<2>(Load::bulk_and_shear_yz), Strain<2>{}) << "a load of space";
}

TEST(PairsOfLoads, OfThePlaneAreThree) {
  int of_plane = 0;
  for (const auto& pair : pairs_of_loads) of_plane += has_load<2>(pair.both) ? 1 : 0;
  EXPECT_EQ(of_plane, 3);
  EXPECT_TRUE(has_load<3>(Load::shear_zx_and_axial_shear));
}

TEST(PairsOfLoads, AreNamedByBoth) {
  EXPECT_EQ(name_of(Load::shear_and_bulk), "shear + bulk");
  EXPECT_EQ(name_of(Load::shear), "shear");
}

// An isotropic body stores the sum of the energies under orthogonal strains.
TEST(PairsOfLoads, OfAnIsotropicBodyHaveTheSumOfTheModuli) {
  const auto stiffness = isotropic_stiffness<3>({.bulk = 5.0, .shear = 2.0});
  const auto modulus = [&](Load load) {
    const auto strain = engineering_strain<3>(unit_strain<3>(load));
    return strain.dot(stiffness * strain);
  };
  for (const auto& pair : pairs_of_loads) {
    EXPECT_NEAR(modulus(pair.both), modulus(pair.one) + modulus(pair.other), 1e-14) << name_of(pair.both);
  }
}

}  // namespace
}  // namespace breccia
