#include "virtual_test/bulk_test.hpp"

#include <gtest/gtest.h>

namespace breccia {
namespace {

// Equal strains along both axes in plane strain cause a stress of K + G/3.
TEST(BulkTest, InPlaneStrainHasAThirdOfTheShearModulus) {
  const auto bulk = bulk_modulus_of(PronySeries(7.0), PronySeries(3.0), 2);
  EXPECT_DOUBLE_EQ(bulk.equilibrium(), 6.0);
  EXPECT_DOUBLE_EQ(shear_in_bulk_test(2), 1.0 / 3.0);
  EXPECT_EQ(symbol_of_bulk_test(2), "K + G/3");
  EXPECT_EQ(formula_of_bulk_test(2), "K(t) + G(t)/3");
}

TEST(BulkTest, OfACubeIsThatOfTheBulkModulus) {
  EXPECT_EQ(bulk_modulus_of(PronySeries(7.0), PronySeries(3.0), 3).equilibrium(), 7.0);
  EXPECT_EQ(shear_in_bulk_test(3), 0.0);
  EXPECT_EQ(symbol_of_bulk_test(3), "K");
  EXPECT_EQ(formula_of_bulk_test(3), "K(t)");
}

}  // namespace
}  // namespace breccia
