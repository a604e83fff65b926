#include "breccia/viscoelasticity/law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/creep_law.hpp"
#include "breccia/viscoelasticity/law_series.hpp"
#include "breccia/viscoelasticity/relaxation_law.hpp"

#include "viscoelasticity/law_values.hpp"
#include "viscoelasticity/noise.hpp"

namespace breccia {
namespace {

using ::testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto bituminous = LawForm::two_springs_two_parabolas_dashpot;

/// Ten values to the power of the exponents from one to another, five a decade.
std::vector<double> decades(double first, double last) {
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(std::lround(5.0 * (last - first))); ++i) {
    values.push_back(std::pow(10.0, first + 0.2 * i));
  }
  return values;
}

struct Sweep {
  std::vector<double> frequencies, storage, loss;
};

Sweep sweep_of(const RelaxationLaw& law, double first, double last, Noise noise) {
  Sweep sweep = {decades(first, last), {}, {}};
  for (const double omega : sweep.frequencies) {
    const auto modulus = carson_modulus(law, {0.0, omega});
    sweep.storage.push_back(noise(modulus.real()));
    sweep.loss.push_back(noise(modulus.imag()));
  }
  return sweep;
}

std::vector<double> creep_of(const CreepLaw& law, const std::vector<double>& times, Noise noise) {
  std::vector<double> compliances;
  for (const double t : times) compliances.push_back(noise(compliance_at(law, t)));
  return compliances;
}

LawFit fitted(LawForm form, const Sweep& sweep, const GivenParameters& given = {}) {
  return fit_law_to_dynamic_moduli(form, sweep.frequencies, sweep.storage, sweep.loss, given);
}

const FittedParameter& parameter(const LawFit& fit, std::string_view key) {
  return *std::ranges::find(fit.parameters, key, &FittedParameter::key);
}

/// How many of its standard errors, which are finite and less than the value, a parameter is from the truth.
double errors_off(const LawFit& fit, std::string_view key, double truth) {
  const auto& found = parameter(fit, key);
  EXPECT_GT(found.standard_error, 0.0) << key;
  EXPECT_LT(found.standard_error, found.value) << key;
  return std::abs(found.value - truth) / found.standard_error;
}

const std::vector<TwoSpringsTwoParabolasDashpot> binders_and_mixture = {{0.1, 1e9, 2.2, 1.945e-3, 0.22, 0.63, 50.0},
                                                                        {210.0, 1e9, 4.6, 0.378, 0.22, 0.555, 808.0},
                                                                        {86.3e6, 26e9, 2.52, 0.8348, 0.22, 0.65, 43.3}};

TEST(LawFit, FindsTheParametersOfExactData) {
  for (const auto& law : binders_and_mixture) {
    const auto fit = fitted(bituminous, sweep_of(law, -3.0, 5.0, Noise(0.0)));
    EXPECT_LT(fit.quality.worst_error, 1e-9);
    const std::vector<std::pair<std::string_view, double>> truth = {{"static", law.static_modulus},
                                                                    {"glassy", law.glassy_modulus},
                                                                    {"delta", law.delta},
                                                                    {"time", law.time},
                                                                    {"k", law.k},
                                                                    {"h", law.h},
                                                                    {"beta", law.beta}};
    for (const auto& [key, value] : truth) {
      EXPECT_NEAR(parameter(fit, key).value / value, 1.0, 1e-6) << key;
      EXPECT_EQ(parameter(fit, key).origin, ParameterOrigin::fitted) << key;
    }
  }
}

TEST(LawFit, ItsSeriesIsThatOfTheLaw) {
  const auto& law = binders_and_mixture.front();
  const auto fit = fitted(bituminous, sweep_of(law, -3.0, 5.0, Noise(0.0)));
  const auto series = series_of(RelaxationLaw(law));
  for (const double t : decades(-5.0, 3.0)) EXPECT_NEAR(fit.series.at(t) / series.at(t), 1.0, 1e-6);
}

struct Coverage {
  int within_one = 0, within_two = 0, all = 0;
};

/// How many of the parameters of noisy sweeps are within one and two of their standard errors of the truth.
Coverage coverage_of(const TwoSpringsTwoParabolasDashpot& law) {
  Coverage coverage;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto fit = fitted(bituminous, sweep_of(law, -3.0, 5.0, Noise(0.01, seed)));
    for (const auto& [key, value] : std::vector<std::pair<std::string_view, double>>{
             {"glassy", law.glassy_modulus}, {"delta", law.delta}, {"time", law.time}, {"k", law.k}, {"h", law.h}}) {
      const double off = errors_off(fit, key, value);
      coverage.within_one += off < 1.0 ? 1 : 0;
      coverage.within_two += off < 2.0 ? 1 : 0;
      ++coverage.all;
    }
  }
  return coverage;
}

// Of a normal distribution 68 % are within one standard deviation and 95 % within two.
TEST(LawFit, StatesItsErrors) {
  for (const auto& law : binders_and_mixture) {
    const auto [within_one, within_two, all] = coverage_of(law);
    EXPECT_GE(within_one, 50 * all / 100);
    EXPECT_LE(within_one, 80 * all / 100);
    EXPECT_GE(within_two, 85 * all / 100);
    EXPECT_LE(within_two, 99 * all / 100);
  }
}

TEST(LawFit, LeavesOutWhatTheDataDoNotShow) {
  // 0.1 Pa of a static modulus lies far below the smallest storage modulus and its noise.
  const auto fit = fitted(bituminous, sweep_of(binders_and_mixture.front(), -3.0, 5.0, Noise(0.01)));
  EXPECT_EQ(parameter(fit, "static").origin, ParameterOrigin::limit);
  EXPECT_EQ(parameter(fit, "static").value, 0.0);
  EXPECT_EQ(parameter(fit, "beta").origin, ParameterOrigin::fitted);
  EXPECT_LT(errors_off(fit, "beta", 50.0), 3.0);
  // A material without a dashpot.
  const TwoSpringsTwoParabolasDashpot huet_sayegh = {1e6, 2e9, 3.0, 1e-4, 0.2, 0.55, infinity};
  const auto without = fitted(bituminous, sweep_of(huet_sayegh, -3.0, 5.0, Noise(0.01)));
  EXPECT_EQ(parameter(without, "beta").origin, ParameterOrigin::limit);
  EXPECT_EQ(parameter(without, "beta").value, infinity);
  EXPECT_EQ(parameter(without, "static").origin, ParameterOrigin::fitted);
}

TEST(LawFit, KeepsWhatIsGiven) {
  const auto& law = binders_and_mixture.front();
  const auto fit = fitted(bituminous, sweep_of(law, -1.0, 2.0, Noise(0.01)), {{"glassy", 1e9}, {"static", 0.0}});
  EXPECT_EQ(parameter(fit, "glassy").value, 1e9);
  EXPECT_EQ(parameter(fit, "glassy").standard_error, 0.0);
  EXPECT_EQ(parameter(fit, "static").origin, ParameterOrigin::given);
  EXPECT_LT(errors_off(fit, "h", law.h), 3.0);
}

// The formula is the same when its two parabolic elements change places.
TEST(LawFit, PutsTheParabolicElementsInOrder) {
  Eigen::VectorXd values(7);
  values << 1e6, 1e9, 3.0, 0.1, 0.6, 0.2, 40.0;
  const auto ordered = in_order(bituminous, values);
  EXPECT_EQ(ordered[4], 0.2);
  EXPECT_EQ(ordered[5], 0.6);
  const TwoSpringsTwoParabolasDashpot as_given = {1e6, 1e9, 3.0, 0.1, 0.6, 0.2, 40.0};
  for (const double omega : decades(-6.0, 6.0)) {
    const auto before = carson_modulus(RelaxationLaw(as_given), {0.0, omega});
    const auto after = carson_modulus(std::get<RelaxationLaw>(law_with(bituminous, values)), {0.0, omega});
    EXPECT_LT(std::abs(after / before - 1.0), 1e-12);
  }
  EXPECT_EQ(in_order(bituminous, ordered), ordered);
}

// A relaxation of almost a single time: no series of few terms follows its exponent of 0.99. The others are those that
// suit the data best with 0.95.
TEST(LawFit, StaysWhereASeriesFollowsTheLaw) {
  const auto fit =
      fitted(LawForm::fractional_zener, sweep_of(FractionalZener{1e6, 1e9, 1.0, 0.99}, -4.0, 4.0, Noise(0.01)));
  EXPECT_EQ(parameter(fit, "exponent").origin, ParameterOrigin::bound);
  EXPECT_EQ(parameter(fit, "exponent").value, 0.95);
  EXPECT_EQ(parameter(fit, "exponent").standard_error, infinity);
  EXPECT_LT(parameter(fit, "unrelaxed").standard_error, 0.1 * parameter(fit, "unrelaxed").value);
  // One per cent more or less of any other parameter does not suit them better.
  const auto sweep = sweep_of(FractionalZener{1e6, 1e9, 1.0, 0.99}, -4.0, 4.0, Noise(0.01));
  const auto misfit_with = [&](std::string_view key, double factor) {
    GivenParameters given;
    for (const auto& one : fit.parameters) given.emplace_back(one.key, one.value * (one.key == key ? factor : 1.0));
    given.erase(std::ranges::find(given, key == "time" ? "unrelaxed" : "time", &GivenParameters::value_type::first));
    const auto other = fitted(LawForm::fractional_zener, sweep, given);
    double sum = 0.0;
    for (std::size_t i = 0; i < sweep.storage.size(); ++i) {
      sum += std::pow(other.quality.fitted[i] / sweep.storage[i] - 1.0, 2);
      sum += std::pow(other.quality.fitted[sweep.storage.size() + i] / sweep.loss[i] - 1.0, 2);
    }
    return sum;
  };
  for (const auto* key : {"equilibrium", "unrelaxed", "time"}) {
    EXPECT_GT(misfit_with(key, 1.01), misfit_with(key, 1.0)) << key;
    EXPECT_GT(misfit_with(key, 0.99), misfit_with(key, 1.0)) << key;
  }
}

// Creep that begins from nothing does not show an instantaneous compliance: it stays above a millionth of the data.
TEST(LawFit, CreepWithoutAnInstantaneousPartIsNoStifferThanAMillionTimes) {
  const auto times = decades(0.0, 7.0);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    std::vector<double> compliances;
    Noise noise(0.01, seed);
    for (const double t : times) compliances.push_back(noise(1e-11 * std::pow(t, 0.4)));
    const auto fit = fit_law_to_compliances(LawForm::power_law_creep, times, compliances);
    EXPECT_GE(parameter(fit, "instantaneous").value, 0.9e-17);
    EXPECT_LT(errors_off(fit, "exponent", 0.4), 4.0);
  }
}

TEST(LawFit, FractionalZenerInFrequencyAndInTime) {
  const FractionalZener law = {1e6, 1e9, 1.0, 0.5};
  const auto dynamic = fitted(LawForm::fractional_zener, sweep_of(law, -4.0, 4.0, Noise(0.01)));
  EXPECT_LT(errors_off(dynamic, "exponent", 0.5), 3.0);
  EXPECT_LT(errors_off(dynamic, "equilibrium", 1e6), 3.0);
  const auto series = series_of(RelaxationLaw(law));
  const auto times = decades(-4.0, 6.0);
  std::vector<double> moduli;
  Noise noise(0.01);
  for (const double t : times) moduli.push_back(noise(series.at(t)));
  const auto relaxation = fit_law_to_moduli(LawForm::fractional_zener, times, moduli);
  EXPECT_LT(errors_off(relaxation, "exponent", 0.5), 3.0);
  EXPECT_LT(errors_off(relaxation, "unrelaxed", 1e9), 3.0);
  EXPECT_LT(relaxation.quality.median_error, 0.01);
}

TEST(LawFit, CreepByPowersAndLogarithms) {
  const auto times = decades(0.0, 7.0);
  const auto power = fit_law_to_compliances(LawForm::power_law_creep, times,
                                            creep_of(PowerLawCreep{1e-11, 3e-12, 3600.0, 0.3}, times, Noise(0.01)));
  EXPECT_LT(errors_off(power, "exponent", 0.3), 3.0);
  EXPECT_LT(errors_off(power, "instantaneous", 1e-11), 3.0);
  // The time of a power law is only the place at which `creep` holds.
  EXPECT_EQ(parameter(power, "time").origin, ParameterOrigin::of_no_effect);
  const double at = parameter(power, "time").value;
  EXPECT_NEAR(std::log10(at), std::round(std::log10(at)), 1e-12);
  EXPECT_LT(errors_off(power, "creep", 3e-12 * std::pow(at / 3600.0, 0.3)), 3.0);

  const auto natural = fit_law_to_compliances(
      LawForm::logarithmic_creep, times, creep_of(LogarithmicCreep{4e-11, 2e-11, 86400.0, 1.0}, times, Noise(0.01)));
  EXPECT_EQ(parameter(natural, "exponent").origin, ParameterOrigin::limit);
  EXPECT_LT(errors_off(natural, "time", 86400.0), 3.0);

  // The basic creep of the model B3, whose exponent and time are known.
  const auto b3 = creep_of(LogarithmicCreep{4e-11, 2e-11, 86400.0, 0.1}, times, Noise(0.01));
  const auto kept =
      fit_law_to_compliances(LawForm::logarithmic_creep, times, b3, {{"time", 86400.0}, {"exponent", 0.1}});
  EXPECT_LT(errors_off(kept, "creep", 2e-11), 3.0);
  // Without them seven decades do not tell the exponent from the time: other values meet the data as well.
  const auto free = fit_law_to_compliances(LawForm::logarithmic_creep, times, b3);
  EXPECT_GT(std::abs(std::log10(parameter(free, "time").value / 86400.0)), 1.0);
  EXPECT_LT(free.quality.median_error, 0.015);
}

TEST(LawFit, RefusesWhatDoesNotSuit) {
  const auto sweep = sweep_of(binders_and_mixture.front(), -3.0, 5.0, Noise(0.0));
  const auto message = [](const auto& fit) -> std::string {
    try {
      fit();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(message([&] { fitted(LawForm::power_law_creep, sweep); }),
              HasSubstr("power-law-creep is a creep compliance"));
  EXPECT_THAT(message([&] { fit_law_to_compliances(bituminous, sweep.frequencies, sweep.storage); }),
              HasSubstr("2s2p1d is a modulus"));
  EXPECT_THAT(message([&] {
                fitted(bituminous, sweep, {{"exponent", 0.5}});
              }),
              HasSubstr("exponent: not a parameter of 2s2p1d, which has static, glassy, delta, time, k, h, beta"));
  EXPECT_THAT(message([&] {
                fitted(bituminous, sweep, {{"k", 1.5}});
              }),
              HasSubstr("k: expected a number between 0 and 1, got 1.5"));
  EXPECT_THAT(message([&] {
                fitted(bituminous, sweep, {{"glassy", 0.0}});
              }),
              HasSubstr("glassy: expected a positive number, got 0"));
  EXPECT_THAT(message([&] {
                fit_law_to_dynamic_moduli(bituminous, std::vector{1.0, 2.0, 3.0}, std::vector{1.0, 2.0, 3.0},
                                          std::vector{1.0, 1.0, 1.0});
              }),
              HasSubstr("2s2p1d has 7 unknowns: expected at least 10 data, got 6"));
  EXPECT_THAT(message([&] {
                fitted(LawForm::fractional_zener, sweep,
                       {{"equilibrium", 0.0}, {"unrelaxed", 1e9}, {"time", 1.0}, {"exponent", 0.5}});
              }),
              HasSubstr("all parameters of the law are given"));
}

}  // namespace
}  // namespace breccia
