#include "assessment/observed_model.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "filled_binder.hpp"
#include "messages.hpp"
#include "viscoelasticity/engineering_moduli.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

Observation observation(ObservedModulus modulus, ObservedCurve curve, double at) {
  return {.modulus = modulus, .curve = curve, .at = at, .value = 1e6, .deviation = 0.02};
}

/// The predictions of a composite at the medians of the priors.
Eigen::VectorXd predicted(const std::vector<Observation>& observations, const std::vector<Unknown>& unknowns = {}) {
  const ObservedModel model({test::filled_binder()}, unknowns, observations);
  return model.predictions(Eigen::VectorXd::Zero(model.size()));
}

/// The series of the composite under a load, which are exact for the reduced response.
PronySeries series(TestLoad load) {
  static const auto results = test::filled_binder().responder.respond();
  return preferred_test(results.front().tests, load, Boundary::periodic).series;
}

TEST(ObservedModel, PredictsTheCurvesOfTheResponder) {
  const auto shear = series(TestLoad::isotropic());
  const auto bulk = PronySeries::difference(series(Load::bulk), shear.scaled(1.0 / 3.0));
  const EngineeringModuli engineering(shear, bulk);
  for (const double t : {3e-6, 1e-4, 2e-2}) {
    const auto values = predicted({observation(ObservedModulus::shear, ObservedCurve::relaxation, t),
                                   observation(ObservedModulus::young, ObservedCurve::relaxation, t),
                                   observation(ObservedModulus::bulk, ObservedCurve::relaxation, t),
                                   observation(ObservedModulus::p_wave, ObservedCurve::relaxation, t)});
    EXPECT_NEAR(values[0] / shear.at(t), 1.0, 2e-6) << t;
    EXPECT_NEAR(values[1] / engineering.youngs_modulus(t), 1.0, 2e-6) << t;
    EXPECT_NEAR(values[2] / bulk.at(t), 1.0, 2e-6) << t;
    EXPECT_NEAR(values[3] / (bulk.at(t) + 4.0 / 3.0 * shear.at(t)), 1.0, 2e-6) << t;
  }
}

TEST(ObservedModel, PredictsComplianceAndConstantRates) {
  constexpr double t = 2e-4;
  const auto shear = series(TestLoad::isotropic());
  const auto values = predicted({observation(ObservedModulus::shear, ObservedCurve::creep, t),
                                 observation(ObservedModulus::shear, ObservedCurve::constant_rate, t)});
  EXPECT_NEAR(values[0] / creep_compliance(shear).at(t), 1.0, 2e-6);
  // The mean of exp(-t / tau) from 0 to t.
  double mean = shear.equilibrium();
  for (const auto& [time, modulus] : shear.terms()) mean += modulus * time / t * (1.0 - std::exp(-t / time));
  EXPECT_NEAR(values[1] / mean, 1.0, 2e-6);
}

TEST(ObservedModel, PredictsDynamicModuliExactly) {
  constexpr double omega = 3e3;
  const auto expected = series(TestLoad::isotropic()).complex_modulus(omega);
  const auto values = predicted({observation(ObservedModulus::shear, ObservedCurve::storage, omega),
                                 observation(ObservedModulus::shear, ObservedCurve::loss, omega),
                                 observation(ObservedModulus::shear, ObservedCurve::absolute, omega),
                                 observation(ObservedModulus::shear, ObservedCurve::phase, omega)});
  EXPECT_NEAR(values[0] / expected.real(), 1.0, 1e-8);
  EXPECT_NEAR(values[1] / expected.imag(), 1.0, 1e-8);
  EXPECT_NEAR(values[2] / std::abs(expected), 1.0, 1e-8);
  EXPECT_NEAR(values[3], std::arg(expected), 1e-8);
}

TEST(ObservedModel, MovesToATemperature) {
  auto cold = observation(ObservedModulus::shear, ObservedCurve::storage, 2e2);
  cold.temperature = 283.15;
  const auto results = test::filled_binder().responder.at(283.15).respond();
  const auto& test = preferred_test(results.front().tests, TestLoad::isotropic(), Boundary::periodic);
  EXPECT_NEAR(predicted({cold})[0] / test.series.complex_modulus(2e2).real(), 1.0, 1e-8);
}

/// A model of all kinds of measurements at once, of the values that the composite has. The bulk loss modulus of a box
/// in plane strain may be negative, and is left out then.
ObservedModel with_unknowns(const std::vector<Unknown>& unknowns) {
  constexpr double time = 3e-4;
  std::vector<Observation> all;
  for (const auto& [word, modulus] : words<ObservedModulus>) {
    for (const auto& [name, curve] : words<ObservedCurve>) {
      all.push_back(observation(modulus, curve, is_over_frequency(curve) ? 1.0 / time : time));
      all.back().temperature = 303.15;
    }
  }
  const auto values = predicted(all);
  std::vector<Observation> observations;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].value = values[static_cast<Eigen::Index>(i)];
    if (all[i].value > 0.0) observations.push_back(all[i]);
  }
  auto one = test::filled_binder();
  one.model_deviation = 0.05;
  return {{one}, unknowns, observations};
}

/// All kinds of unknowns but factors.
ObservedModel with_numbers() {
  const std::vector<double> times = {1e-5, 1e-4, 1e-3, 1e-2};
  return with_unknowns({UnknownNumber{"glass", MaterialNumber::shear, Normal{5e9, 0.5e9}},
                        UnknownNumber{"glass", MaterialNumber::bulk, Uniform{5e9, 12e9}},
                        UnknownSpectrum{"binder", times, {1e6, 20.0}},
                        UnknownNumber{"binder", MaterialNumber::equilibrium, LogUniform{1e4, 1e6}},
                        UnknownNumber{"binder", MaterialNumber::c1, Normal{6.5, 0.5}},
                        UnknownNumber{"binder", MaterialNumber::c2, Normal{120.0, 10.0}}});
}

ObservedModel with_factors() {
  return with_unknowns({UnknownNumber{"binder", MaterialNumber::times, LogNormal{1.0, 3.0}},
                        UnknownNumber{"binder", MaterialNumber::modulus, LogNormal{1.0, 3.0}},
                        UnknownNumber{"glass", MaterialNumber::young, LogNormal{12e9, 1.5}},
                        UnknownNumber{"glass", MaterialNumber::poisson, Uniform{0.2, 0.35}}});
}

// Differences of fourth order with a step of 0.01 err by about 1e-8. The measure is the largest entry, or a standard
// deviation where the predictions hardly depend on the unknown.
void expect_jacobian_of_differences(const ObservedModel& model) {
  Eigen::VectorXd at(model.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) at[i] = 0.3 * std::sin(1.0 + 2.0 * static_cast<double>(i));
  const auto jacobian = model.jacobian(at);
  constexpr double step = 1e-2;
  for (Eigen::Index c = 0; c < model.size(); ++c) {
    const auto moved = [&](double steps) -> Eigen::VectorXd {
      return model.deviations(at + steps * step * Eigen::VectorXd::Unit(model.size(), c));
    };
    const Eigen::VectorXd difference = (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * step);
    const double largest = std::max(1.0, difference.cwiseAbs().maxCoeff());
    EXPECT_LT((jacobian.col(c) - difference).cwiseAbs().maxCoeff(), 1e-6 * largest)
        << model.components()[static_cast<std::size_t>(c)].name;
  }
}

TEST(ObservedModel, HasTheJacobianOfFiniteDifferences) {
  expect_jacobian_of_differences(with_numbers());
  expect_jacobian_of_differences(with_factors());
}

TEST(ObservedModel, NamesItsComponents) {
  const auto model = with_numbers();
  std::vector<std::string> names;
  for (const auto& component : model.components()) names.push_back(component.name);
  EXPECT_THAT(names,
              testing::ElementsAre("glass.shear", "glass.bulk", "binder.spectrum at 10 us", "binder.spectrum at 100 us",
                                   "binder.spectrum at 1 ms", "binder.spectrum at 10 ms", "binder.equilibrium",
                                   "binder.c1", "binder.c2", "model of filled binder"));
}

TEST(ObservedModel, RefusesAllMistakesAtOnce) {
  const auto message = test::message_of<InputError>([] {
    ObservedModel({test::filled_binder()},
                  {UnknownNumber{"glas", MaterialNumber::shear, Normal{5e9, 0.5e9}},
                   UnknownNumber{"binder", MaterialNumber::times, LogNormal{1.0, 1.0}}},
                  {});
  });
  EXPECT_THAT(message, HasSubstr("glas.shear: no material \"glas\""));
  EXPECT_THAT(message, HasSubstr("binder.times: expected a factor above 1, got 1"));
}

TEST(ObservedModel, RefusesAnElasticMaterialThatWasNotSampled) {
  const auto study = test::two_stages();
  const ObservedComposite elastic = {.name = "box",
                                     .responder = responder_of(study, solve(study)),
                                     .stage = "coarse",
                                     .boundary = Boundary::displacement};
  const auto message = test::message_of<InputError>([&] {
    ObservedModel({elastic}, {UnknownNumber{"glass", MaterialNumber::shear, Normal{5e9, 0.5e9}}},
                  {observation(ObservedModulus::shear, ObservedCurve::relaxation, 1e-3)});
  });
  EXPECT_THAT(message, HasSubstr("glass does not vary"));
  EXPECT_THAT(message, HasSubstr("tests.quasistatic.vary"));
}

TEST(ObservedModel, RefusesValuesThatAreNotPositive) {
  auto one = observation(ObservedModulus::shear, ObservedCurve::relaxation, 1e-3);
  one.value = 0.0;
  one.deviation = -1.0;
  const auto message = test::message_of<InputError>([&] { ObservedModel({test::filled_binder()}, {}, {one}); });
  EXPECT_THAT(message, HasSubstr("measurement 1: expected a positive value"));
  EXPECT_THAT(message, HasSubstr("measurement 1: expected a positive standard deviation"));
}

}  // namespace
}  // namespace breccia
