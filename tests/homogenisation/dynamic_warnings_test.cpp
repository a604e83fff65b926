#include "homogenisation/dynamic_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Tests creep_tests(double transits) {
  Tests tests;
  tests.methods = {Method::dynamic};
  tests.boundaries = {Boundary::traction};
  tests.dynamic.creep_ramp_transits = transits;
  return tests;
}

TEST(DynamicWarnings, OfATractionRampThatLeavesTheBoxRinging) {
  EXPECT_EQ(warning_of_ringing(creep_tests(5.0)), std::nullopt) << "the ramp by default";
  for (const double transits : {0.1, 0.3, 1.0}) {
    EXPECT_THAT(warning_of_ringing(creep_tests(transits)).value_or(""), HasSubstr("up to 100 % of its compliance"));
  }
  EXPECT_THAT(warning_of_ringing(creep_tests(3.0)).value_or(""), HasSubstr("3 transits"));
  auto others = creep_tests(1.0);
  others.boundaries = {Boundary::displacement};
  EXPECT_EQ(warning_of_ringing(others), std::nullopt);
  others = creep_tests(1.0);
  others.methods = {Method::quasistatic};
  EXPECT_EQ(warning_of_ringing(others), std::nullopt);
}

// A window begins after six transits.
TEST(DynamicWarnings, OfARampThatIsGivenAsATime) {
  auto tests = creep_tests(5.0);
  tests.dynamic.ramp_time = 1.0;
  EXPECT_EQ(warning_of_ringing(tests), std::nullopt);
  std::vector<TimeDomain> domains(1);
  domains.front().ramp = 1.0;
  domains.front().window = {6.0, 100.0};
  EXPECT_THAT(warnings_on_domains(tests, Boundary::traction, domains), ElementsAre(HasSubstr("a ramp of 1 transits")));
  EXPECT_THAT(warnings_on_domains(tests, Boundary::displacement, domains), IsEmpty());
  domains.front().ramp = 5.0;
  EXPECT_THAT(warnings_on_domains(tests, Boundary::traction, domains), IsEmpty());
}

TEST(DynamicWarnings, OfPronyTermsThatAreLeftOutAndMatter) {
  std::vector<TimeDomain> domains(2);
  domains.back().reduction_error = 0.001;
  EXPECT_THAT(warnings_on_domains(creep_tests(5.0), Boundary::traction, domains), IsEmpty());
  domains.back().reduction_error = 0.21;
  EXPECT_THAT(warnings_on_domains(creep_tests(5.0), Boundary::displacement, domains),
              ElementsAre(HasSubstr("by up to 21 %")));
}

}  // namespace
}  // namespace breccia
