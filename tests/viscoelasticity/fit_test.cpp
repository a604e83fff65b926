#include "breccia/viscoelasticity/fit.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "viscoelasticity/binder.hpp"
#include "viscoelasticity/noise.hpp"

namespace breccia {
namespace {

std::vector<double> logarithmic(double first, double last, int per_decade) {
  std::vector<double> values;
  const int count = static_cast<int>(std::lround(per_decade * std::log10(last / first)));
  for (int i = 0; i <= count; ++i) values.push_back(first * std::pow(10.0, static_cast<double>(i) / per_decade));
  return values;
}

struct Errors {
  double median, worst;
};

template <class Found, class Truth>
Errors compare(const std::vector<double>& times, const Found& found, const Truth& truth) {
  std::vector<double> errors;
  errors.reserve(times.size());
  for (const double t : times) errors.push_back(std::abs(found(t) / truth(t) - 1.0));
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors.back()};
}

const auto times = logarithmic(1e-8, 1e-2, 20);

double modulus(double t) {
  return binder.at(t);
}

TEST(Fit, RelaxationWithNoise) {
  std::vector<double> data;
  data.reserve(times.size());
  Noise noise(0.01);
  for (const double t : times) data.push_back(noise(binder.at(t)));
  const auto fit = fit_relaxation(times, data);
  const auto errors = compare(
      times, [&](double t) { return fit.series.at(t); }, modulus);
  EXPECT_LT(errors.median, 0.02);
  EXPECT_LT(errors.worst, 0.04);
  // The fit finds the scatter, and its standard error is below that of a datum.
  EXPECT_NEAR(fit.quality.median_error, 0.0067, 0.002);
  EXPECT_LT(fit.quality.standard_errors[times.size() / 2], 0.01);
  // The true error is within the stated one nearly everywhere.
  std::size_t inside = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double error = std::abs(fit.series.at(times[i]) / binder.at(times[i]) - 1.0);
    inside += error < 3.0 * fit.quality.standard_errors[i] ? 1U : 0U;
  }
  EXPECT_GT(static_cast<double>(inside), 0.9 * static_cast<double>(times.size()));
}

TEST(Fit, WithAsManyTermsAsDataItsErrorIsUnknown) {
  const std::vector<double> few{1.0, 10.0, 100.0};
  const std::vector<double> data{3e6, 2e6, 1e6};
  for (const double error : fit_relaxation(few, data).quality.standard_errors) EXPECT_TRUE(std::isnan(error));
}

TEST(Fit, CreepWithNoiseGivesTheRelaxationModulus) {
  const auto truth = creep_compliance(binder);
  std::vector<double> data;
  data.reserve(times.size());
  Noise noise(0.01);
  for (const double t : times) data.push_back(noise(truth.at(t)));
  const auto fit = fit_creep(times, data);
  const auto creep = compare(
      times, [&](double t) { return fit.compliance.at(t); }, [&](double t) { return truth.at(t); });
  EXPECT_LT(creep.median, 0.02);
  EXPECT_LT(creep.worst, 0.04);
  const auto series = relaxation_modulus(fit.compliance);
  const auto relaxation = compare(
      times, [&](double t) { return series.at(t); }, modulus);
  EXPECT_LT(relaxation.median, 0.02);
  // At the end of the data the modulus depends on the compliance at later times.
  EXPECT_LT(relaxation.worst, 0.10);
}

TEST(Fit, DynamicModuliWithNoise) {
  const auto frequencies = logarithmic(1e2, 1e8, 10);
  std::vector<double> storage, loss;
  Noise noise(0.01);
  for (const double omega : frequencies) {
    const auto value = binder.complex_modulus(omega);
    storage.push_back(noise(value.real()));
    loss.push_back(noise(value.imag()));
  }
  const auto fit = fit_dynamic(frequencies, storage, loss);
  const auto errors = compare(
      frequencies, [&](double omega) { return std::abs(fit.series.complex_modulus(omega)); },
      [&](double omega) { return std::abs(binder.complex_modulus(omega)); });
  EXPECT_LT(errors.median, 0.02);
  EXPECT_LT(errors.worst, 0.04);
  EXPECT_EQ(fit.quality.fitted.size(), 2 * frequencies.size());
}

TEST(Fit, RampIsTakenOut) {
  // One Maxwell element and a spring, are strained at a constant rate until T; a fit that assumes a step would be 30 %
  // off at T.
  const double ramp = 1e-3, tau = 2e-3, g1 = 3e6, ge = 1e6;
  const auto data_times = logarithmic(1e-4, 1e-1, 20);
  std::vector<double> data;
  data.reserve(data_times.size());
  for (const double t : data_times) {
    const double end = std::min(t, ramp);
    data.push_back((ge * end + g1 * tau * (std::exp(-(t - end) / tau) - std::exp(-t / tau))) / ramp);
  }
  const auto fit = fit_relaxation(data_times, data, {.ramp = ramp});
  const auto errors = compare(
      data_times, [&](double t) { return fit.series.at(t); }, [&](double t) { return ge + g1 * std::exp(-t / tau); });
  EXPECT_LT(errors.worst, 0.01);
}

TEST(Fit, RampedCreepOfAMaxwellElement) {
  const double ramp = 0.5, j0 = 2.0, fluidity = 3.0;
  const auto data_times = logarithmic(0.05, 50.0, 10);
  std::vector<double> data;
  data.reserve(data_times.size());
  for (const double t : data_times) {
    data.push_back(t < ramp ? (j0 * t + 0.5 * fluidity * t * t) / ramp : j0 + fluidity * (t - 0.5 * ramp));
  }
  const auto fit = fit_creep(data_times, data, {.ramp = ramp});
  EXPECT_NEAR(fit.compliance.at(5.0), j0 + 5.0 * fluidity, 1e-6);
  EXPECT_NEAR(fit.compliance.fluidity(), fluidity, 1e-6);
}

TEST(Fit, RefusesBadData) {
  const std::vector<double> rising = {1.0, 2.0, 3.0}, falling = {1.0, 3.0, 2.0}, negative = {1.0, -1.0, 1.0};
  EXPECT_THROW(fit_relaxation(falling, rising), InputError);
  EXPECT_THROW(fit_relaxation(rising, negative), InputError);
  EXPECT_THROW(fit_creep(rising, std::vector<double>{1.0}), InputError);
  EXPECT_THROW(fit_dynamic(rising, rising, negative), InputError);
  EXPECT_THROW(fit_relaxation(std::vector<double>{1.0}, std::vector<double>{1.0}), InputError);
}

}  // namespace
}  // namespace breccia
