#include "homogenisation/plan/expected_moduli.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr Moduli incompressible = {.bulk = 1e12, .shear = 1.0};
constexpr Moduli rigid = {.bulk = 1e12, .shear = 1e10};

double stiffening(double fraction, int dimensions) {
  return expected_moduli(incompressible, {{rigid, fraction}}, dimensions).shear;
}

TEST(ExpectedModuli, OfAFewRigidParticlesAreThoseOfEinstein) {
  constexpr double few = 1e-4;
  EXPECT_NEAR((stiffening(few, 2) - 1.0) / few, 2.0, 1e-2);
  EXPECT_NEAR((stiffening(few, 3) - 1.0) / few, 2.5, 1e-2);
}

/// Krieger and Dougherty (1959): (1 - phi / phi_jammed)^(-[eta] phi_jammed).
TEST(ExpectedModuli, OfRigidParticlesInAnIncompressibleMatrixGrowWithoutBoundTowardsJamming) {
  for (const double fraction : {0.1, 0.4, 0.6}) {
    EXPECT_NEAR(std::log(stiffening(fraction, 2)), -2.0 * 0.84 * std::log1p(-fraction / 0.84), 1e-3) << fraction;
  }
  for (const double fraction : {0.1, 0.35}) {
    EXPECT_NEAR(std::log(stiffening(fraction, 3)), -2.5 * 0.70 * std::log1p(-fraction / 0.70), 1e-3) << fraction;
  }
}

TEST(ExpectedModuli, AreThoseOfTheMatrixWithoutParticlesAndOfParticlesThatEqualIt) {
  constexpr Moduli matrix = {.bulk = 3e9, .shear = 1e9};
  for (const int dimensions : {2, 3}) {
    EXPECT_EQ(expected_moduli(matrix, {}, dimensions).shear, matrix.shear);
    const auto same = expected_moduli(matrix, {{matrix, 0.5}}, dimensions);
    EXPECT_NEAR(same.bulk, matrix.bulk, 1e-6 * matrix.bulk);
    EXPECT_NEAR(same.shear, matrix.shear, 1e-6 * matrix.shear);
  }
}

TEST(ExpectedModuli, OfTwoFillersThatAreEqualAreThoseOfOne) {
  constexpr Moduli matrix = {.bulk = 3e9, .shear = 1e6}, glass = {.bulk = 40e9, .shear = 30e9};
  const auto one = expected_moduli(matrix, {{glass, 0.4}}, 2),
             two = expected_moduli(matrix, {{glass, 0.1}, {glass, 0.3}}, 2);
  EXPECT_NEAR(two.shear, one.shear, 1e-9 * one.shear);
  EXPECT_NEAR(two.bulk, one.bulk, 1e-9 * one.bulk);
}

/// Bound of Hashin and Shtrikman for the bulk modulus of spheres, with the shear modulus of the matrix: the lower one
/// of a stiff filler, the upper one of a soft one.
double bulk_bound(const Moduli& matrix, const Moduli& filler, double fraction) {
  const double star = 4.0 / 3.0 * matrix.shear;
  return 1.0 / ((1.0 - fraction) / (matrix.bulk + star) + fraction / (filler.bulk + star)) - star;
}

TEST(ExpectedModuli, AreFurtherFromTheMatrixThanTheBoundOfHashinAndShtrikman) {
  constexpr Moduli matrix = {.bulk = 3e9, .shear = 1e9};
  for (const double fraction : {0.05, 0.3, 0.5}) {
    for (const Moduli stiff : {Moduli{60e9, 40e9}, Moduli{6e9, 3e9}}) {
      EXPECT_GT(expected_moduli(matrix, {{stiff, fraction}}, 3).bulk, bulk_bound(matrix, stiff, fraction));
    }
    constexpr Moduli soft = {1e5, 1e4};
    EXPECT_LT(expected_moduli(matrix, {{soft, fraction}}, 3).bulk, bulk_bound(matrix, soft, fraction));
  }
}

/// Shear moduli of random boxes, each the mean of 10 or 16 packings at the time of the largest stiffening
/// (docs/verification.md, "How often the scatter of packings holds").
struct Computed {
  int dimensions;
  double fraction;
  Moduli matrix, filler;  ///< [Pa]
  double shear;           ///< [Pa]
};

constexpr std::array<Computed, 12> computed = {{
    {2, 0.3222, {8.295e9, 3.211e5}, {4.024e9, 2.118e9}, 7.612e5},    // discs of one size
    {2, 0.5729, {6.567e9, 6.795e7}, {4.918e10, 1.724e10}, 4.803e8},  //
    {2, 0.4907, {5.852e9, 8.448e6}, {2.564e10, 1.794e10}, 3.587e7},  // with wide gaps
    {2, 0.5441, {6.175e9, 2.095e6}, {5.528e9, 4.627e9}, 1.366e7},    // of many sizes
    {2, 0.4854, {6.766e9, 2.935e5}, {6.99e9, 2.805e9}, 1.361e6},     // ellipses
    {2, 0.4434, {8.047e9, 4.315e7}, {3.318e10, 1.136e10}, 1.639e8},  // polygons
    {2, 0.8672, {5.735e9, 6.371e5}, {1.126e10, 5.857e9}, 1.176e8},   // grains
    {2, 0.3301, {8.686e9, 5.797e8}, {553.1, 476.2}, 2.294e8},        // soft discs
    {2, 0.304, {4.991e9, 5.635e8}, {2594.0, 758.1}, 2.375e8},        //
    {3, 0.321, {5.23e9, 1.705e5}, {1.156e10, 3.455e9}, 5.092e5},     // spheres
    {3, 0.2257, {3.538e9, 3.654e5}, {9.133e9, 8.499e9}, 7.438e5},    // of many sizes
    {3, 0.1505, {6.613e9, 5.593e8}, {225.2, 120.5}, 4.303e8},        // soft spheres
}};

TEST(ExpectedModuli, AreNearThoseOfRandomBoxes) {
  for (const auto& box : computed) {
    const auto found = expected_moduli(box.matrix, {{box.filler, box.fraction}}, box.dimensions);
    const double ratio = std::log(found.shear / box.matrix.shear) / std::log(box.shear / box.matrix.shear);
    EXPECT_GT(ratio, 0.85) << box.fraction;
    EXPECT_LT(ratio, 1.2) << box.fraction;
  }
}

}  // namespace
}  // namespace breccia
