#include "quasistatic/stepping/log_time_stepping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "checkpoint/checkpoint.hpp"
#include "quasistatic/composites.hpp"
#include "temporary_directory.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

constexpr std::array all_loads = {Load::shear, Load::diagonal_shear, Load::bulk};

/// Relaxation modulus of the model composite in pure shear [MPa] from an independent computation with 80 steps a
/// decade.
struct ModelValues {
  Volumetric volumetric;
  int cells;
  std::array<double, 8> moduli;  ///< moduli right after the step, and at 1, 3, 10, 30, 50, 70 and 100 ms
};

const std::vector<double> model_times = {1e-3, 3e-3, 10e-3, 30e-3, 50e-3, 70e-3, 100e-3};

const std::vector<ModelValues> model_values = {
    {Volumetric::standard, 24, {0.964958, 0.884355, 0.744429, 0.419205, 0.118464, 0.0636499, 0.0483280, 0.0383740}},
    {Volumetric::standard, 48, {0.919087, 0.841164, 0.705966, 0.392194, 0.102588, 0.0491607, 0.0336075, 0.0232485}},
    {Volumetric::standard, 96, {0.899330, 0.822523, 0.689297, 0.380336, 0.0957985, 0.0435595, 0.0284248, 0.0183909}},
    {Volumetric::averaged, 48, {0.919464, 0.841293, 0.705651, 0.390748, 0.0997332, 0.0457392, 0.0297947, 0.0189817}}};

class ModelComposite : public testing::TestWithParam<ModelValues> {};

TEST_P(ModelComposite, AgreesWithAnIndependentComputation) {
  const auto& [volumetric, cells, moduli] = GetParam();
  auto times = test::logarithmic(1e-4, 0.1, 40);
  times.insert(times.end(), model_times.begin(), model_times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b < a * (1.0 + 1e-9); }),
              times.end());
  const auto problem = test::model_composite(cells, volumetric, Boundary::displacement);
  const auto response = run_log_time_stepping(problem, std::array{Load::shear}, times).responses.front();
  EXPECT_NEAR(response.unrelaxed / (1e6 * moduli[0]), 1.0, 1e-3);
  for (std::size_t i = 0; i < model_times.size(); ++i) {
    const auto found = std::lower_bound(times.begin(), times.end(), model_times[i] * (1.0 - 1e-9)) - times.begin();
    const double tolerance = model_times[i] < 0.09 ? 2e-3 : 5e-3;
    EXPECT_NEAR(response.values[static_cast<std::size_t>(found)] / (1e6 * moduli[i + 1]), 1.0, tolerance)
        << "at " << model_times[i] << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, ModelComposite, testing::ValuesIn(model_values), [](const auto& chosen) {
  return fmt::format("{}_{}_cells", test::words_of(chosen.param.volumetric), chosen.param.cells);
});

/// Both moduli relax, at different times.
const Material polymer = {"polymer", 1000.0, PronySeries(2e6, {{3e-3, 1e6}}),
                          PronySeries(0.1e6, {{1e-3, 0.5e6}, {1e-2, 0.3e6}})};

/// The modulus that a load measures is a sum of series.
PronySeries measured(Load load) {
  if (load != Load::bulk) return polymer.shear;
  auto terms = polymer.bulk.terms();
  for (const auto& [time, modulus] : polymer.shear.terms()) terms.push_back({time, modulus / 3.0});
  return {polymer.bulk.equilibrium() + polymer.shear.equilibrium() / 3.0, terms};
}

TEST(LogTimeStepping, AHomogeneousBoxRelaxesAsItsMaterial) {
  const auto times = test::logarithmic(1e-5, 1.0, 10);
  for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
    const auto result = run_log_time_stepping(test::homogeneous(polymer, boundary), all_loads, times);
    for (const auto& response : result.responses) {
      const auto expected = measured(response.load);
      EXPECT_NEAR(response.unrelaxed / expected.unrelaxed(), 1.0, 1e-9);
      for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_NEAR(response.values[i] / expected.at(times[i]), 1.0, 1e-9);
      }
    }
  }
}

TEST(LogTimeStepping, AHomogeneousBoxCreepsAsItsMaterial) {
  const auto times = test::logarithmic(1e-5, 1.0, 40);
  const auto result = run_log_time_stepping(test::homogeneous(polymer, Boundary::traction), all_loads, times);
  for (const auto& response : result.responses) {
    const auto expected = creep_compliance(measured(response.load));
    for (std::size_t i = 0; i < times.size(); ++i) {
      // Creep is not linear over a step, which causes an error of second order; the estimate shows it.
      const double error = std::abs(response.values[i] / expected.at(times[i]) - 1.0);
      EXPECT_LT(error, 1e-3);
      EXPECT_LT(error, 2.0 * response.error_estimates[i] + 1e-6);
    }
  }
}

TEST(LogTimeStepping, IsOfSecondOrderInTheSteps) {
  const auto problem = test::homogeneous(polymer, Boundary::traction);
  const auto exact = creep_compliance(polymer.shear);
  std::vector<double> errors;
  for (const int per_decade : {10, 20, 40}) {
    const auto times = test::logarithmic(1e-6, 1e-2, per_decade);
    const auto response = run_log_time_stepping(problem, std::array{Load::shear}, times).responses.front();
    errors.push_back(std::abs(response.values.back() / exact.at(times.back()) - 1.0));
  }
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.4);
  EXPECT_NEAR(errors[1] / errors[2], 4.0, 0.4);
}

TEST(LogTimeStepping, LayersInSeriesAddTheirCompliances) {
  // Layers across x under a periodic boundary: the shear stress is the same in all of them.
  auto problem = test::homogeneous(polymer, Boundary::periodic);
  problem.materials.push_back({"stiff", 1000.0, PronySeries(5e6), PronySeries(4e6)});
  problem.discretisation.paint([](const Vector<2>& point) { return point[0] < 2e-3; }, 1);
  const auto times = test::logarithmic(1e-5, 0.1, 40);
  const auto response = run_log_time_stepping(problem, std::array{Load::shear}, times).responses.front();
  const auto soft = creep_compliance(polymer.shear);
  std::vector<RetardationTerm> terms;
  for (const auto& [time, compliance] : soft.terms()) terms.push_back({time, compliance * 2.0 / 3.0});
  const auto expected = relaxation_modulus(CreepCompliance(soft.instantaneous() * 2.0 / 3.0 + 1.0 / 3.0 / 4e6, terms));
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(response.values[i] / expected.at(times[i]), 1.0, 5e-4) << times[i];
  }
}

TEST(LogTimeStepping, RefusesACheckpointOfMoreStepsThanItHasTimes) {
  const auto problem = test::homogeneous(polymer, Boundary::periodic);
  const std::array loads = {Load::shear, Load::bulk};
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "stepping.checkpoint.h5";
  int asked = 0;
  Checkpoint stopped(path, {"hash", "version"}, {.interval = 0.0, .stop = [&] { return ++asked > 6; }});
  const std::vector times = {1e-4, 2e-4, 4e-4, 8e-4, 2e-3, 4e-3, 8e-3, 2e-2};
  EXPECT_THROW(run_log_time_stepping(problem, loads, times, {}, {}, &stopped), Interrupted);
  Checkpoint resumed(path, {"hash", "version"}, {});
  EXPECT_TRUE(resumed.look_for_earlier().empty());
  EXPECT_THROW(run_log_time_stepping(problem, loads, std::vector{1e-4, 2e-4}, {}, {}, &resumed), FileError);
}

TEST(LogTimeStepping, RefusesWhatIsIncomplete) {
  auto problem = test::homogeneous(polymer, Boundary::displacement);
  const std::array loads = {Load::shear};
  EXPECT_THROW(run_log_time_stepping(problem, loads, std::vector<double>{}), InputError);
  for (const auto& times : std::vector<std::vector<double>>{
           {2.0, 1.0}, {1.0, 1.0}, {1.0, std::nan(""), 2.0}, {1.0, std::numeric_limits<double>::infinity()}}) {
    EXPECT_THROW(run_log_time_stepping(problem, loads, times), InputError);
  }
  EXPECT_THROW(run_log_time_stepping(problem, {}, std::vector<double>{1.0}), InputError) << "no load";
  problem.discretisation.paint([](const Vector<2>&) { return true; }, 3);
  EXPECT_THROW(run_log_time_stepping(problem, loads, std::vector<double>{1.0}), InputError);
  problem.discretisation.paint([](const Vector<2>&) { return true; }, no_phase);
  EXPECT_THROW(run_log_time_stepping(problem, loads, std::vector<double>{1.0}), InputError);
}

}  // namespace
}  // namespace breccia
