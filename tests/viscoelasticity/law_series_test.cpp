#include "breccia/viscoelasticity/law_series.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

// Laws as Prony series, against their closed forms.
namespace breccia {
namespace {

using Complex = std::complex<double>;

// The bitumens H0 and W6 of Some et al. 2022 (examples/materials/asphalt/parameters.csv).
const TwoSpringsTwoParabolasDashpot h0 = {.static_modulus = 0.1,
                                          .glassy_modulus = 1e9,
                                          .delta = 2.2,
                                          .time = 1.94507827e-3,
                                          .k = 0.22,
                                          .h = 0.63,
                                          .beta = 50};
const TwoSpringsTwoParabolasDashpot w6 = {.static_modulus = 210.0,
                                          .glassy_modulus = 1e9,
                                          .delta = 4.6,
                                          .time = 0.378112337,
                                          .k = 0.22,
                                          .h = 0.555320631,
                                          .beta = 808};

/// Largest relative deviation of a series from a complex modulus over a range of angular frequencies.
template <class Exact>
double worst_of(const PronySeries& series, double first, double last, const Exact& exact) {
  double worst = 0.0;
  for (double omega = first; omega <= last; omega *= 1.37) {
    const Complex modulus = exact(Complex(0.0, omega));
    const double deviation = std::abs(series.complex_modulus(omega) - modulus) / std::abs(modulus);
    if (!(deviation <= worst)) worst = deviation;  // a deviation that is no number as well
  }
  return worst;
}

// |E*| and its phase from the same parameters by another program, in Python.
TEST(LawSeries, BitumenHasTheModulusOfItsFormula) {
  struct Row {
    TwoSpringsTwoParabolasDashpot law;
    double omega, absolute, degrees;
  };
  for (const auto& [law, omega, absolute, degrees] :
       {Row{h0, 1e-3, 0.07253e6, 80.76}, Row{h0, 1.0, 14.89e6, 56.35}, Row{h0, 300.0, 218.2e6, 26.52},
        Row{w6, 1e-3, 9.448e6, 43.6}, Row{w6, 1.0, 122.8e6, 23.51}, Row{w6, 300.0, 378e6, 13.24}}) {
    const auto modulus = series_of(law).complex_modulus(omega);
    EXPECT_NEAR(std::abs(modulus) / absolute, 1.0, 1e-3) << omega;
    EXPECT_NEAR(std::arg(modulus) * 180.0 / std::numbers::pi, degrees, 0.05) << omega;
  }
}

TEST(LawSeries, Of2S2P1DOverTwentyDecades) {
  for (const auto& law : {h0, w6}) {
    const auto exact = [&law](Complex p) {
      return law.static_modulus + (law.glassy_modulus - law.static_modulus) /
                                      (1.0 + law.delta * std::pow(p * law.time, -law.k) +
                                       std::pow(p * law.time, -law.h) + 1.0 / (p * law.beta * law.time));
    };
    const auto found = series_of(law);
    EXPECT_LT(worst_of(found, 1e-10, 1e10, exact), 1.1e-3);
    EXPECT_LT(found.terms().size(), 70U);
    EXPECT_NEAR(found.unrelaxed() / law.glassy_modulus, 1.0, 1e-12);
    EXPECT_EQ(found.equilibrium(), law.static_modulus);
  }
}

// Without a dashpot the model is that of Huet and Sayegh.
TEST(LawSeries, WithoutADashpotTheModulusStaysAboveTheStaticOne) {
  auto law = w6;
  law.beta = std::numeric_limits<double>::infinity();
  const auto exact = [&law](Complex p) {
    return law.static_modulus + (law.glassy_modulus - law.static_modulus) /
                                    (1.0 + law.delta * std::pow(p * law.time, -law.k) + std::pow(p * law.time, -law.h));
  };
  EXPECT_LT(worst_of(series_of(law), 1e-10, 1e10, exact), 1.1e-3);
}

// M(t) = M_0 exp(t / tau) erfc(sqrt(t / tau)) for alpha = 1/2 without an equilibrium modulus.
TEST(LawSeries, FractionalMaxwellRelaxesAsTheErrorFunction) {
  const double modulus = 2e9, tau = 3.0;
  const auto series = series_of(FractionalZener{0.0, modulus, tau, 0.5});
  for (double t = 1e-10; t < 1e11; t *= 3.0) {
    const double x = std::sqrt(t / tau);
    const double scaled =
        x < 20.0 ? std::exp(x * x) * std::erfc(x) : (1.0 - 0.5 / (x * x)) / (x * std::sqrt(std::numbers::pi));
    EXPECT_NEAR(series.at(t) / (modulus * scaled), 1.0, 2e-3) << t;
  }
}

// The spectrum of Cole and Cole: H = (M_0 - M_inf) / pi sin(pi a) / (u^a + u^-a + 2 cos(pi a)), u = time / tau.
TEST(LawSeries, SpectrumOfTheFractionalZenerModel) {
  const double a = 0.3, tau = 1e-2;
  const FractionalZener law = {1e6, 1e9, tau, a};
  for (const double time : {1e-12, 1e-5, 1e-2, 1.0, 1e8}) {
    const double power = std::pow(time / tau, a), pi = std::numbers::pi;
    const double exact = 999e6 / pi * std::sin(pi * a) / (power + 1.0 / power + 2.0 * std::cos(pi * a));
    EXPECT_NEAR(relaxation_spectrum(law, time) / exact, 1.0, 1e-12) << time;
  }
}

TEST(LawSeries, OfTheFractionalZenerModelForAllExponents) {
  for (const double a : {0.01, 0.05, 0.2, 0.5, 0.8, 0.9}) {
    const auto exact = [a](Complex p) { return 1e5 + 1e9 * std::pow(p, a) / (1.0 + std::pow(p, a)); };
    const auto found = series_of(FractionalZener{1e5, 1e5 + 1e9, 1.0, a});
    EXPECT_LT(worst_of(found, 1e-12, 1e12, exact), 1.1e-3) << a;
    EXPECT_NEAR(found.unrelaxed() / (1e5 + 1e9), 1.0, 1e-12) << a;
  }
  EXPECT_THROW(series_of(FractionalZener{0.0, 1e9, 1.0, 0.99}), InputError);
}

// The fractional Maxwell model is power-law creep: J(p) = J_0 + J_1 Gamma(1 + n) (p t_1)^-n.
TEST(LawSeries, OfPowerLawCreep) {
  const double j0 = 2e-11, j1 = 1.5e-11, t1 = 86400.0;
  for (const double n : {0.02, 0.1, 0.3, 0.7, 0.9, 0.98}) {
    const auto exact = [&](Complex p) { return 1.0 / (j0 + j1 * std::tgamma(1.0 + n) * std::pow(p * t1, -n)); };
    const auto found = series_of(PowerLawCreep{j0, j1, t1, n});
    EXPECT_LT(worst_of(found, 1e-11, 1e3, exact), 5e-3) << n;
    EXPECT_NEAR(found.unrelaxed() * j0, 1.0, 1e-12);
    const auto compliance = creep_compliance(found);
    for (double t = 1e-6; t < 1e16; t *= 7.0) {
      EXPECT_NEAR(compliance.at(t) / (j0 + j1 * std::pow(t / t1, n)), 1.0, 1.1e-3) << n << " " << t;
    }
  }
}

// J(p) = J_0 + J_1 e^z E_1(z), z = p t_1, with E_1(i x) = -Ci(x) + i (Si(x) - pi / 2); Ci and Si from Abramowitz and
// Stegun, table 5.1.
TEST(LawSeries, OfLogarithmicCreepInFrequency) {
  const double j0 = 2e-11, j1 = 1.5e-11, t1 = 86400.0;
  const auto series = series_of(LogarithmicCreep{j0, j1, t1, 1.0});
  struct Row {
    double x, si, ci;
  };
  for (const auto& [x, si, ci] : {Row{0.1, 0.0999444611, -1.7278683866}, Row{1.0, 0.9460830704, 0.3374039229},
                                  Row{10.0, 1.6583475942, -0.0454564330}}) {
    const Complex e1(-ci, si - 0.5 * std::numbers::pi);
    const Complex exact = 1.0 / (j0 + j1 * std::polar(1.0, x) * e1);
    EXPECT_LT(std::abs(series.complex_modulus(x / t1) - exact) / std::abs(exact), 1e-3) << x;
  }
}

TEST(LawSeries, OfLogarithmicCreepInTime) {
  const double j0 = 2e-11, j1 = 1.5e-11, t1 = 86400.0;
  for (const double n : {0.1, 0.5, 1.0}) {
    const auto compliance = creep_compliance(series_of(LogarithmicCreep{j0, j1, t1, n}));
    for (double t = 1e-6; t < 1e16; t *= 7.0) {
      EXPECT_NEAR(compliance.at(t) / (j0 + j1 * std::log1p(std::pow(t / t1, n))), 1.0, 1.1e-3) << n << " " << t;
    }
  }
}

// ln(1 + t) has the spectrum e^(-1/lambda); ln(1 + t^n) grows as n ln t, so that its spectrum ends at n.
TEST(LawSeries, SpectrumOfLogarithmicCreep) {
  EXPECT_NEAR(retardation_spectrum(LogarithmicCreep{1.0, 1.0, 1.0, 1.0}, 0.5), std::exp(-2.0), 1e-15);
  EXPECT_NEAR(retardation_spectrum(LogarithmicCreep{1.0, 1.0, 1.0, 1.0 - 1e-7}, 0.5), std::exp(-2.0), 1e-6);
  EXPECT_NEAR(retardation_spectrum(LogarithmicCreep{1.0, 1.0, 1.0, 0.3}, 1e40), 0.3, 1e-10);
  // e^x erfc(sqrt(x)) / 2, x = t_1 / lambda, for the square root of time.
  for (const double x : {0.01, 1.0, 30.0}) {
    EXPECT_NEAR(retardation_spectrum(LogarithmicCreep{1.0, 1.0, 1.0, 0.5}, 1.0 / x),
                0.5 * std::exp(x) * std::erfc(std::sqrt(x)), 1e-6)
        << x;
  }
  // Before t_1 it is that of t^n.
  const PowerLawCreep power = {1.0, 1.0, 1.0, 0.3};
  EXPECT_NEAR(retardation_spectrum(LogarithmicCreep{1.0, 1.0, 1.0, 0.3}, 1e-20) / retardation_spectrum(power, 1e-20),
              1.0, 1e-4);
}

TEST(LawSeries, RefusesParametersOutOfRange) {
  const auto refused = [](const auto& law) {
    try {
      static_cast<void>(series_of(law));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto with = [](auto law, auto member, double value) {
    law.*member = value;
    return law;
  };
  using Bitumen = TwoSpringsTwoParabolasDashpot;
  using testing::StartsWith;
  EXPECT_THAT(refused(with(h0, &Bitumen::k, 0.7)),
              StartsWith("k: expected a number above 0 and up to h, 0.63, got 0.7"));
  EXPECT_THAT(refused(with(h0, &Bitumen::h, 1.0)), StartsWith("h: expected a number between 0 and 1, got 1"));
  EXPECT_THAT(refused(with(h0, &Bitumen::static_modulus, 2e9)), StartsWith("glassy: expected more than static"));
  EXPECT_THAT(refused(with(h0, &Bitumen::beta, 0.0)), StartsWith("beta: expected a positive number"));
  EXPECT_THAT(refused(with(h0, &Bitumen::delta, -1.0)), StartsWith("delta: expected a positive number"));
  EXPECT_THAT(refused(FractionalZener{-1.0, 1.0, 1.0, 0.5}), StartsWith("equilibrium: expected a modulus"));
  EXPECT_THAT(refused(FractionalZener{0.0, 1.0, 0.0, 0.5}), StartsWith("time: expected a positive time"));
  EXPECT_THAT(refused(FractionalZener{0.0, 1.0, 1.0, 1.0}), StartsWith("exponent: expected a number between 0 and 1"));
  EXPECT_THAT(refused(PowerLawCreep{0.0, 1.0, 1.0, 0.5}), StartsWith("instantaneous: expected a positive number"));
  EXPECT_THAT(refused(PowerLawCreep{1.0, 1.0, 1.0, 1.0}), StartsWith("exponent: expected a number between 0 and 1"));
  EXPECT_THAT(refused(LogarithmicCreep{1.0, 0.0, 1.0, 1.0}), StartsWith("creep: expected a positive number"));
  EXPECT_THAT(refused(LogarithmicCreep{1.0, 1.0, 1.0, 1.5}), StartsWith("exponent: expected a number above 0"));
}

}  // namespace
}  // namespace breccia
