#include "breccia/discretisation/tensor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "breccia/discretisation/load.hpp"

namespace breccia {
namespace {

TEST(SymmetricTensor, ComponentsStandInVoigtsOrder) {
  const Strain<3> strain{.xx = 1.0, .yy = 2.0, .zz = 3.0, .yz = 4.0, .zx = 5.0, .xy = 6.0};
  for (int place = 0; place < 6; ++place) EXPECT_EQ(component(strain, place), place + 1.0);
  EXPECT_EQ(component(strain, 1, 2), 4.0);
  EXPECT_EQ(component(strain, 0, 2), 5.0);
  EXPECT_EQ(component(strain, 2, 0), 5.0);
  EXPECT_EQ(component(strain, 1, 0), 6.0);
  const Stress<2> stress{.xx = 1.0, .yy = 2.0, .xy = 3.0};
  for (int place = 0; place < 3; ++place) EXPECT_EQ(component(stress, place), place + 1.0);
  EXPECT_EQ(component(stress, 0, 1), 3.0);
}

TEST(SymmetricTensor, ContractionCountsShearsTwice) {
  const Strain<3> strain{.xx = 1.0, .yy = 2.0, .zz = 3.0, .yz = 4.0, .zx = 5.0, .xy = 6.0};
  const Stress<3> stress{.xx = 7.0, .yy = 8.0, .zz = 9.0, .yz = 10.0, .zx = 11.0, .xy = 12.0};
  EXPECT_EQ(contraction(stress, strain), 7.0 + 16.0 + 27.0 + 2.0 * (40.0 + 55.0 + 72.0));
  EXPECT_EQ(contraction(Stress<2>{7.0, 8.0, 12.0}, Strain<2>{1.0, 2.0, 6.0}), 7.0 + 16.0 + 144.0);
}

TEST(SymmetricTensor, TimesAVector) {
  const Strain<3> strain{.xx = 1.0, .yy = 2.0, .zz = 3.0, .yz = 4.0, .zx = 5.0, .xy = 6.0};
  EXPECT_EQ(product(strain, Vector<3>{1.0, 10.0, 100.0}), (Vector<3>{561.0, 426.0, 345.0}));
  EXPECT_EQ(product(Strain<2>{1.0, 2.0, 6.0}, Vector<2>{1.0, 10.0}), (Vector<2>{61.0, 26.0}));
}

/// The stress of an isotropic body; in 2D of plane strain, with lambda = K - 2 G / 3 in either.
template <int dim>
Stress<dim> stress_of(double bulk, double shear, const Strain<dim>& strain) {
  double dilatation = 0.0;
  for (int axis = 0; axis < dim; ++axis) dilatation += component(strain, axis);
  Stress<dim> stress;
  for (int place = 0; place < tensor_components<dim>; ++place) {
    component(stress, place) = 2.0 * shear * component(strain, place);
    if (place < dim) component(stress, place) += (bulk - 2.0 / 3.0 * shear) * dilatation;
  }
  return stress;
}

template <int dim>
void expect_moduli(double of_bulk_load) {
  constexpr double bulk = 3.0, shear = 0.7;
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    const double modulus = load == Load::bulk ? of_bulk_load : shear;
    const auto stress = stress_of<dim>(bulk, shear, unit_strain<dim>(load));
    EXPECT_NEAR(modulus_of(load, stress), modulus, 1e-15);
    // The strain of the body under the unit stress is the unit strain times 1 / M.
    const auto strain = scaled(1.0 / modulus, unit_strain<dim>(load));
    const auto caused = stress_of<dim>(bulk, shear, strain);
    for (int place = 0; place < tensor_components<dim>; ++place) {
      EXPECT_NEAR(component(caused, place), component(unit_stress<dim>(load), place), 1e-15);
    }
    EXPECT_NEAR(compliance_of(load, strain), 1.0 / modulus, 1e-15);
  }
}

TEST(Load, TellsModulusAndComplianceOfAnIsotropicBody) {
  expect_moduli<2>(3.0 + 0.7 / 3.0);
  expect_moduli<3>(3.0);
}

}  // namespace
}  // namespace breccia
