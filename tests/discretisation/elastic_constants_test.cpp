// Tests of the constants of crystals and of their means.

#include <gtest/gtest.h>

#include "breccia/discretisation/crystals.hpp"

namespace breccia {
namespace {

ElasticConstants cubic(double c11, double c12, double c44) {
  ElasticConstants constants{};
  for (std::size_t i = 1; i <= 3; ++i) {
    constants[place_of_constant(i, i)] = c11;
    constants[place_of_constant(i + 3, i + 3)] = c44;
    for (std::size_t j = i + 1; j <= 3; ++j) constants[place_of_constant(j, i)] = c12;
  }
  return constants;
}

TEST(ElasticConstants, AreThoseOfTheUpperTriangleRowByRow) {
  EXPECT_EQ(place_of_constant(1, 1), 0U);
  EXPECT_EQ(place_of_constant(1, 6), 5U);
  EXPECT_EQ(place_of_constant(2, 2), 6U);
  EXPECT_EQ(place_of_constant(6, 2), 10U);
  EXPECT_EQ(place_of_constant(6, 6), 20U);
}

TEST(ElasticConstants, OfACubicCrystalHaveTheMeansOfVoigtAndReuss) {
  const auto means = isotropic_means(stiffness_tensor(cubic(168.0, 121.0, 75.0)));
  EXPECT_NEAR(means.bulk_voigt, 410.0 / 3.0, 1e-11);
  EXPECT_NEAR(means.bulk_reuss, 410.0 / 3.0, 1e-11);
  EXPECT_NEAR(means.shear_voigt, (47.0 + 3.0 * 75.0) / 5.0, 1e-11);
  EXPECT_NEAR(means.shear_reuss, 5.0 / (4.0 / 47.0 + 3.0 / 75.0), 1e-11);
  EXPECT_EQ(means.shear(), 0.5 * (means.shear_voigt + means.shear_reuss));
}

TEST(ElasticConstants, OfAnIsotropicSolidHaveItsModuli) {
  const auto means = isotropic_means(stiffness_tensor(cubic(3.0 + 4.0, 3.0 - 2.0, 3.0)));
  for (const double bulk : {means.bulk_voigt, means.bulk_reuss, means.bulk()}) EXPECT_NEAR(bulk, 3.0, 1e-14);
  for (const double shear : {means.shear_voigt, means.shear_reuss, means.shear()}) EXPECT_NEAR(shear, 3.0, 1e-14);
}

TEST(ElasticConstants, AreStableWhereNoStrainHasNegativeEnergy) {
  EXPECT_NEAR(least_stiffness<3>(stiffness_tensor(cubic(168.0, 121.0, 75.0))), 47.0, 1e-11);
  EXPECT_NEAR(least_stiffness<3>(stiffness_tensor(cubic(168.0, 121.0, 10.0))), 20.0, 1e-11) << "twice C44";
  EXPECT_LT(least_stiffness<3>(stiffness_tensor(cubic(100.0, 121.0, 75.0))), 0.0);
}

}  // namespace
}  // namespace breccia
