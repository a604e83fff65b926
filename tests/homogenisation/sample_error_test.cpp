#include "homogenisation/sample_error.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "homogenisation/box/effective_number.hpp"

namespace breccia {
namespace {

ErrorRules random(double particles) {
  return {.sample = SampleKind::particles, .effective_particles = particles};
}

TEST(SampleError, FallsWithTheRootOfTheParticlesAndGrowsWithTheStiffening) {
  for (const int dimensions : {2, 3}) {
    const auto error = [&](double particles, double stiffening) {
      return sample_error(random(particles), dimensions, Boundary::periodic, TestLoad::isotropic(), stiffening).value();
    };
    EXPECT_NEAR(error(400.0, 5.0), 0.5 * error(100.0, 5.0), 1e-15);
    EXPECT_NEAR(error(100.0, 25.0), 2.0 * error(100.0, 5.0), 1e-15);
    EXPECT_NEAR(error(100.0, 0.2), error(100.0, 5.0), 1e-15) << "a soft filler";
    EXPECT_EQ(error(100.0, 1.0), 0.0) << "a filler equal to the matrix";
  }
}

TEST(SampleError, IsLargerForOneShearThanForTheMeanOfAll) {
  for (const int dimensions : {2, 3}) {
    const auto mean = sample_error(random(100.0), dimensions, Boundary::periodic, TestLoad::isotropic(), 3.0).value();
    EXPECT_GT(sample_error(random(100.0), dimensions, Boundary::periodic, Load::shear, 3.0).value(), 1.4 * mean);
    EXPECT_LT(sample_error(random(100.0), dimensions, Boundary::periodic, Load::bulk, 3.0).value(), mean);
  }
}

TEST(SampleError, IsSmallerForGrainsAndNoneForARegularArray) {
  auto rules = random(100.0);
  const auto of_particles = sample_error(rules, 2, Boundary::periodic, Load::shear, 3.0);
  rules.sample = SampleKind::grains;
  EXPECT_LT(sample_error(rules, 2, Boundary::periodic, Load::shear, 3.0), of_particles);
  rules.sample = SampleKind::whole;
  EXPECT_EQ(sample_error(rules, 2, Boundary::periodic, Load::shear, 3.0), 0.0);
  rules.sample = SampleKind::unknown;
  EXPECT_FALSE(sample_error(rules, 2, Boundary::periodic, Load::shear, 3.0)) << "an image, or a list of particles";
}

TEST(SampleError, HasNoRuleForAFewParticlesNorForAModulusThatIsNone) {
  EXPECT_FALSE(sample_error(random(3.0), 2, Boundary::periodic, Load::shear, 2.0));
  EXPECT_FALSE(sample_error(random(100.0), 2, Boundary::periodic, Load::shear, 0.0));
  EXPECT_FALSE(sample_error(random(100.0), 2, Boundary::periodic, Load::shear, std::nan("")));
}

TEST(EffectiveNumber, CountsEqualParticlesAndHardlySmallOnes) {
  EXPECT_EQ(effective_number({}), 0.0);
  EXPECT_DOUBLE_EQ(effective_number(std::array{2.0, 2.0, 2.0}), 3.0);
  std::vector<double> volumes(1000, 1e-3);
  volumes.push_back(100.0);
  EXPECT_NEAR(effective_number(volumes), 101.0 * 101.0 / 10000.001, 1e-9);
}

}  // namespace
}  // namespace breccia
