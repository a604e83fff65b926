#include "homogenisation/engineering_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TestResult test_with(double modulus, std::optional<double> error) {
  TestResult test = {.id = {.load = Load::shear, .grid = TestGrid(12)}};
  test.modulus = {{1.0, modulus}};
  test.errors = {{.grid = error, .sample = 0.0, .solver = 0.0, .matrix = 0.0}};
  return test;
}

/// K, E and nu from a shear modulus and the modulus of a test in bulk.
struct Solid {
  double bulk, young, poisson;

  Solid(double g, double tested, int dimensions)
      : bulk(dimensions == 2 ? tested - g / 3.0 : tested),
        young(9.0 * bulk * g / (3.0 * bulk + g)),
        poisson((3.0 * bulk - 2.0 * g) / (6.0 * bulk + 2.0 * g)) {}
};

TEST(EngineeringErrors, AreTheLargestChangesWithinThoseOfTheTests) {
  constexpr double of_shear = 2e-5, of_test = 3e-5;
  for (const int dimensions : {2, 3}) {
    for (const double tested : {0.5, 2.0, 40.0}) {
      const double g = 1.0;
      const Solid here(g, tested, dimensions);
      double bulk = 0.0, young = 0.0, poisson = 0.0;
      for (const double shear_sign : {-1.0, 1.0}) {
        for (const double test_sign : {-1.0, 1.0}) {
          const Solid there(g * (1.0 + shear_sign * of_shear), tested * (1.0 + test_sign * of_test), dimensions);
          bulk = std::max(bulk, std::abs(there.bulk / here.bulk - 1.0));
          young = std::max(young, std::abs(there.young / here.young - 1.0));
          poisson = std::max(poisson, std::abs(there.poisson - here.poisson));
        }
      }
      const auto errors = engineering_errors(test_with(g, of_shear), test_with(tested, of_test), 0, dimensions);
      EXPECT_NEAR(errors.bulk.value(), bulk, 1e-3 * bulk) << dimensions << " " << tested;
      EXPECT_NEAR(errors.young.value(), young, 1e-3 * young) << dimensions << " " << tested;
      EXPECT_NEAR(errors.poisson.value(), poisson, 1e-3 * poisson) << dimensions << " " << tested;
    }
  }
}

TEST(EngineeringErrors, OfSpaceAreNoLargerThanTheLargerOneOfTheTests) {
  for (const double bulk : {0.3, 1.0, 10.0}) {
    const auto young = engineering_errors(test_with(1.0, 0.02), test_with(bulk, 0.05), 0, 3).young.value();
    EXPECT_GT(young, 0.02);
    EXPECT_LT(young, 0.05);
  }
}

TEST(EngineeringErrors, AreUnknownWithThoseOfTheTestsAndWithoutABulkModulus) {
  const auto is_unknown = [](const TestResult& shear, const TestResult& bulk, int dimensions) {
    const auto errors = engineering_errors(shear, bulk, 0, dimensions);
    return !errors.bulk && !errors.young && !errors.poisson;
  };
  const auto known = test_with(1.0, 0.02), unknown = test_with(1.0, std::nullopt);
  EXPECT_FALSE(is_unknown(known, known, 3));
  EXPECT_TRUE(is_unknown(unknown, known, 3));
  EXPECT_TRUE(is_unknown(known, unknown, 3));
  EXPECT_TRUE(is_unknown(known, test_with(1.0 / 3.0, 0.02), 2)) << "K + G/3 = G/3";
  auto later = known;
  later.modulus = {{2.0, 1.0}};
  EXPECT_TRUE(is_unknown(known, later, 3));
  auto without = known;
  without.errors.clear();
  EXPECT_TRUE(is_unknown(known, without, 3));
}

}  // namespace
}  // namespace breccia
