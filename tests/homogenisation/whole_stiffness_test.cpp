#include "homogenisation/whole_stiffness.hpp"

#include <cmath>
#include <cstddef>
#include <random>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/error.hpp"

namespace breccia {
namespace {

/// A positive definite stiffness without any symmetry.
template <int dim>
StiffnessTensor<dim> triclinic() {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  StiffnessTensor<dim> factor;
  for (auto& entry : factor.reshaped()) entry = normal(random);
  return factor * factor.transpose() + StiffnessTensor<dim>::Identity();
}

template <int dim>
std::vector<double> constants_of(const StiffnessTensor<dim>& stiffness) {
  std::vector<double> constants;
  for (int i = 0; i < stiffness.rows(); ++i) {
    for (int j = i; j < stiffness.cols(); ++j) constants.push_back(stiffness(i, j));
  }
  return constants;
}

/// The test of a body of this stiffness under a load. At the second of two times the body has half the stiffness.
template <int dim>
TestResult test_of(const StiffnessTensor<dim>& stiffness, Load load) {
  const auto strain = engineering_strain<dim>(unit_strain<dim>(load));
  const double modulus = strain.dot(stiffness * strain);
  TestResult test{.id = {.load = load, .boundary = Boundary::periodic, .grid = TestGrid(20)}};
  test.modulus = {{1.0, modulus}, {2.0, 0.5 * modulus}};
  const ModulusError error{.grid = load == Load::bulk ? 0.03 : 0.01, .sample = 0.0, .solver = 0.0, .matrix = 0.0};
  test.errors = {error, error};
  return test;
}

template <int dim>
StageStiffness found_of(const StiffnessTensor<dim>& stiffness) {
  std::vector<TestResult> tests, pairs;
  for (const auto load : isotropic_shears(dim)) tests.push_back(test_of<dim>(stiffness, load));
  tests.push_back(test_of<dim>(stiffness, Load::bulk));
  tests.push_back(tests.front());
  tests.back().id.load = TestLoad::isotropic();
  for (const auto& pair : pairs_of_loads) {
    if (has_load<dim>(pair.both)) pairs.push_back(test_of<dim>(stiffness, pair.both));
  }
  const auto all = whole_stiffness(dim, tests, pairs);
  EXPECT_EQ(all.size(), 1U);
  return all.at(0);
}

template <int dim>
void expect_found() {
  const auto stiffness = triclinic<dim>();
  const auto found = found_of<dim>(stiffness);
  EXPECT_EQ(found.test, (TestId{.load = TestLoad::isotropic(), .boundary = Boundary::periodic, .grid = TestGrid(20)}));
  ASSERT_EQ(found.samples.size(), 2U);
  const auto expected = constants_of<dim>(stiffness);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found.samples[0].constants.at(i), expected[i], 1e-13 * stiffness.norm()) << i;
    EXPECT_NEAR(found.samples[1].constants.at(i), 0.5 * expected[i], 1e-13 * stiffness.norm()) << i;
  }
  EXPECT_EQ(found.samples[0].time, 1.0);
  EXPECT_EQ(found.samples[0].error, 0.03) << "the largest";
}

TEST(WholeStiffness, FollowsFromTheModuliOfLoadsAndPairs) {
  expect_found<2>();
  expect_found<3>();
}

TEST(WholeStiffness, WithoutPairsIsNotFound) {
  const auto stiffness = triclinic<2>();
  const std::vector tests = {test_of<2>(stiffness, Load::shear), test_of<2>(stiffness, Load::bulk)};
  EXPECT_TRUE(whole_stiffness(2, tests, {}).empty());
}

TEST(WholeStiffness, WithAnUnknownErrorHasNone) {
  const auto stiffness = triclinic<2>();
  std::vector<TestResult> tests, pairs;
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) tests.push_back(test_of<2>(stiffness, load));
  tests[1].errors[0].sample.reset();
  tests.push_back(tests.front());
  tests.back().id.load = TestLoad::isotropic();
  for (const auto& pair : pairs_of_loads) {
    if (has_load<2>(pair.both)) pairs.push_back(test_of<2>(stiffness, pair.both));
  }
  const auto found = whole_stiffness(2, tests, pairs);
  EXPECT_EQ(found.at(0).samples[0].error, std::nullopt);
  EXPECT_EQ(found.at(0).samples[1].error, 0.03);
}

TEST(IsotropicPart, OfAnIsotropicStiffnessIsItself) {
  const Moduli moduli = {.bulk = 5.0, .shear = 2.0};
  for (const auto& part : {isotropic_part(constants_of<2>(isotropic_stiffness<2>(moduli))),
                           isotropic_part(constants_of<3>(isotropic_stiffness<3>(moduli)))}) {
    EXPECT_NEAR(part.bulk, 5.0, 1e-14);
    EXPECT_NEAR(part.shear, 2.0, 1e-14);
    EXPECT_NEAR(part.anisotropy.value(), 0.0, 1e-14);
  }
}

// A cubic crystal of Zener's ratio A has 6/5 (A^(1/2) - A^(-1/2))^2 (Ranganathan and Ostoja-Starzewski, 2008).
TEST(IsotropicPart, OfACubicCrystalHasTheIndexOfZenersRatio) {
  StiffnessTensor<3> copper = StiffnessTensor<3>::Zero();
  copper.topLeftCorner<3, 3>().setConstant(121.4);
  copper.diagonal() << 168.4, 168.4, 168.4, 75.4, 75.4, 75.4;
  const double zener = 2.0 * 75.4 / (168.4 - 121.4);
  const double expected = 1.2 * std::pow(std::sqrt(zener) - 1.0 / std::sqrt(zener), 2);
  const auto means = isotropic_means(copper);
  for (const auto& axes : {crystal_axes(0.0, 0.0, 0.0), crystal_axes(0.3, 1.1, 2.0)}) {
    const auto part = isotropic_part(constants_of<3>(rotated(copper, axes)));
    EXPECT_NEAR(part.anisotropy.value(), expected, 1e-12);
    EXPECT_NEAR(part.bulk, means.bulk_voigt, 1e-10);
    EXPECT_NEAR(part.shear, means.shear_voigt, 1e-10);
  }
}

// A plane body with two shear moduli a and b has 2 (a + b)^2 / (4 a b) + 1 - 3.
TEST(IsotropicPart, OfAPlaneBodyIsThatOfItsTwoShears) {
  const double kappa = 10.0, diagonal = 3.0, axes = 1.0;
  StiffnessTensor<2> stiffness = StiffnessTensor<2>::Zero();
  stiffness(0, 0) = stiffness(1, 1) = kappa + diagonal;
  stiffness(0, 1) = stiffness(1, 0) = kappa - diagonal;
  stiffness(2, 2) = axes;
  const auto part = isotropic_part(constants_of<2>(stiffness));
  EXPECT_NEAR(part.shear, 2.0, 1e-14);
  EXPECT_NEAR(part.bulk, kappa - 2.0 / 3.0, 1e-14);
  EXPECT_NEAR(part.anisotropy.value(), 2.0 * 16.0 / 12.0 - 2.0, 1e-14);
}

TEST(IsotropicPart, OfAnIndefiniteStiffnessHasNoIndex) {
  StiffnessTensor<2> stiffness = StiffnessTensor<2>::Identity();
  stiffness(2, 2) = 0.0;
  EXPECT_EQ(isotropic_part(constants_of<2>(stiffness)).anisotropy, std::nullopt);
  EXPECT_THROW(isotropic_part(std::vector<double>(7)), InputError);
}

}  // namespace
}  // namespace breccia
