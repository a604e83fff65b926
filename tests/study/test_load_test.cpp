#include "breccia/study/test_load.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/discretisation/tensor.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

template <int dim>
void expect_orthonormal() {
  const auto shears = isotropic_shears(dim);
  // Strains without a change of volume: a matrix of zero trace has one component less.
  ASSERT_EQ(static_cast<int>(shears.size()), tensor_components<dim> - 1);
  for (const auto one : shears) {
    EXPECT_TRUE(has_load<dim>(one));
    double trace = 0.0;
    for (int axis = 0; axis < dim; ++axis) trace += component(unit_strain<dim>(one), axis);
    EXPECT_NEAR(trace, 0.0, 1e-16) << name_of(one);
    for (const auto other : shears) {
      EXPECT_NEAR(contraction(unit_strain<dim>(one), unit_strain<dim>(other)), one == other ? 0.5 : 0.0, 1e-15)
          << name_of(one) << " and " << name_of(other);
    }
  }
}

// The mean of strain : stiffness : strain over an orthogonal basis of all shears is a trace, which no rotation changes.
TEST(IsotropicShears, AreAnOrthogonalBasisInThePlane) {
  expect_orthonormal<2>();
}
TEST(IsotropicShears, AreAnOrthogonalBasisInSpace) {
  expect_orthonormal<3>();
}

TEST(TestLoad, IsALoadOfATestOrTheMeanOfAllShears) {
  EXPECT_TRUE(TestLoad::isotropic().is_isotropic());
  EXPECT_EQ(TestLoad::isotropic().of_test(), std::nullopt);
  EXPECT_EQ(TestLoad(Load::shear_yz).of_test(), Load::shear_yz);
  EXPECT_TRUE(TestLoad(Load::bulk).is_bulk());
  EXPECT_FALSE(TestLoad::isotropic().is_bulk());
  EXPECT_EQ(name_of(TestLoad::isotropic()), "isotropic");
  for (const auto& [word, load] : words<Load>) EXPECT_EQ(name_of(TestLoad(load)), word);
}

TEST(TestLoad, ABoxOfThePlaneLacksThoseOfSpace) {
  EXPECT_TRUE(has_test_load(TestLoad::isotropic(), 2));
  EXPECT_FALSE(has_test_load(Load::axial_shear, 2));
  EXPECT_TRUE(has_test_load(Load::axial_shear, 3));
}

TEST(MainShear, IsTheMeanThenThatOfTheAxesThenTheFirst) {
  using Loads = std::vector<TestLoad>;
  EXPECT_EQ(main_shear(Loads{Load::bulk, Load::shear, TestLoad::isotropic()}), TestLoad::isotropic());
  EXPECT_EQ(main_shear(Loads{Load::bulk, Load::diagonal_shear, Load::shear}), TestLoad(Load::shear));
  EXPECT_EQ(main_shear(Loads{Load::bulk, Load::shear_zx, Load::shear_yz}), TestLoad(Load::shear_zx));
  EXPECT_EQ(main_shear(Loads{Load::bulk}), std::nullopt);
  EXPECT_EQ(main_shear({}), std::nullopt);
}

}  // namespace
}  // namespace breccia
