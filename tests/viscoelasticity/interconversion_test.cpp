#include "breccia/viscoelasticity/interconversion.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "viscoelasticity/binder.hpp"

namespace breccia {
namespace {

double largest_difference(const PronySeries& a, const PronySeries& b, double first, double last) {
  double largest = 0.0;
  for (double t = first; t <= last; t *= 1.3) largest = std::max(largest, std::abs(a.at(t) / b.at(t) - 1.0));
  return largest;
}

TEST(Interconversion, StandardLinearSolid) {
  // J(t) = 1/Ge - (1/Ge - 1/(Ge+G1)) exp(-t Ge / (tau (Ge + G1)))
  const double ge = 2e6, g1 = 6e6, tau = 0.3;
  const auto compliance = creep_compliance(PronySeries(ge, {{tau, g1}}));
  ASSERT_EQ(compliance.terms().size(), 1U);
  EXPECT_NEAR(compliance.instantaneous(), 1.0 / (ge + g1), 1e-22);
  EXPECT_NEAR(compliance.terms()[0].retardation_time, tau * (ge + g1) / ge, 1e-14);
  EXPECT_NEAR(compliance.terms()[0].compliance, 1.0 / ge - 1.0 / (ge + g1), 1e-21);
  EXPECT_EQ(compliance.fluidity(), 0.0);
}

TEST(Interconversion, MaxwellElementFlows) {
  const auto compliance = creep_compliance(PronySeries(0.0, {{2.0, 5.0}}));
  EXPECT_TRUE(compliance.terms().empty());
  EXPECT_DOUBLE_EQ(compliance.at(3.0), 1.0 / 5.0 + 3.0 / 10.0);
  const auto back = relaxation_modulus(compliance);
  ASSERT_EQ(back.terms().size(), 1U);
  EXPECT_NEAR(back.terms()[0].relaxation_time, 2.0, 1e-14);
  EXPECT_NEAR(back.terms()[0].modulus, 5.0, 1e-14);
}

TEST(Interconversion, ElasticSolids) {
  EXPECT_EQ(creep_compliance(PronySeries(4.0)), CreepCompliance(0.25, {}));
  EXPECT_EQ(relaxation_modulus(CreepCompliance(0.25, {})), PronySeries(4.0));
  EXPECT_THROW(creep_compliance(PronySeries(0.0)), InputError);
}

// tests/reference/interconversion.py: partial fractions with 60 digits.
TEST(Interconversion, BinderOverTwentyDecades) {
  const auto compliance = creep_compliance(binder);
  const std::vector<std::pair<double, double>> expected = {
      {1e-12, 5.3726393482651846e-10}, {1e-9, 1.0262076073879674e-9}, {1e-6, 1.3302257697881765e-8},
      {1e-3, 6.6829757847213299e-7},   {1.0, 2.4068238558274122e-6},  {1e3, 9.2699361661725229e-6},
      {1e6, 0.00010055535268326694},   {1e8, 0.0014658078420568962}};
  for (const auto& [time, value] : expected) EXPECT_NEAR(compliance.at(time) / value, 1.0, 1e-12) << time;
}

TEST(Interconversion, RoundTripOverTwentyDecades) {
  EXPECT_LT(largest_difference(relaxation_modulus(creep_compliance(binder)), binder, 1e-15, 1e8), 1e-11);
  const PronySeries stiffened(1e5, binder.terms());
  EXPECT_LT(largest_difference(relaxation_modulus(creep_compliance(stiffened)), stiffened, 1e-15, 1e10), 1e-11);
}

TEST(Interconversion, HundredsOfTerms) {
  std::mt19937_64 random(1);
  std::vector<MaxwellTerm> terms;
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  constexpr std::size_t count = 300;
  terms.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    terms.push_back({std::pow(10.0, -14.0 + 22.0 * uniform()), std::pow(10.0, 8.0 * uniform())});
  const PronySeries series(100.0, terms);
  EXPECT_LT(largest_difference(relaxation_modulus(creep_compliance(series)), series, 1e-15, 1e10), 1e-10);
}

TEST(Interconversion, EqualTimesAndEmptyTermsDoNotMatter) {
  const auto plain = creep_compliance(PronySeries(1.0, {{2.0, 5.0}}));
  const auto split = creep_compliance(PronySeries(1.0, {{2.0, 3.0}, {2.0, 2.0}, {7.0, 0.0}}));
  EXPECT_EQ(split, plain);
}

TEST(Interconversion, ComplexCompliancesAreReciprocal) {
  const auto compliance = creep_compliance(binder);
  for (double omega = 1e-7; omega < 1e14; omega *= 37.0) {
    const auto product = compliance.complex_compliance(omega) * binder.complex_modulus(omega);
    EXPECT_NEAR(product.real(), 1.0, 1e-12);
    EXPECT_NEAR(product.imag(), 0.0, 1e-12);
  }
}

TEST(CreepCompliance, RefusesInvalidCompliancesAndTimes) {
  EXPECT_THROW(CreepCompliance(0.0, {}), InputError);
  EXPECT_THROW(CreepCompliance(1.0, {{0.0, 1.0}}), InputError);
  EXPECT_THROW(CreepCompliance(1.0, {{1.0, -1.0}}), InputError);
  EXPECT_THROW(CreepCompliance(1.0, {}, -1.0), InputError);
}

}  // namespace
}  // namespace breccia
