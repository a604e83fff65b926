#include "dynamics/classical.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"

namespace breccia {
namespace {

using testing_materials::soft;

/// A square body of side 0.5 m in the lower left of an otherwise empty box of side 1 m, whose points really move.
std::unique_ptr<DynamicSolver<2>> travelling_body(const DynamicSolver<2>::VelocityField& velocity,
                                                  double courant = 0.2) {
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{20, 20}, 0.05}, no_phase), {soft}};
  problem.discretisation.paint([](const Vector<2>& x) { return x[0] > 0.1 && x[0] < 0.6 && x[1] > 0.1 && x[1] < 0.6; },
                               0);
  problem.boundary = Boundary::traction;
  problem.amplitude = 1.0;
  problem.time_step =
      courant * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.mass_scaling);
  auto run = make_dynamic_solver(Formulation::classical, problem);
  run->set_velocities(velocity);
  return run;
}

TEST(MovingPoints, ARigidBodyCrossesCellsWithoutStress) {
  const Vector<2> velocity = {6.0, 4.0};
  const auto run = travelling_body([&](const Vector<2>&) { return velocity; });
  const auto momentum = run->momentum();
  std::vector<Averages<2>> averages;
  while (run->time() < 0.03) run->advance(1, averages);  // the body moves by 3.6 and 2.4 cells
  for (const auto& [stress, strain] : averages) EXPECT_NEAR(stress.xx, 0.0, 1e-6);
  EXPECT_NEAR(run->momentum()[0], momentum[0], 1e-10 * momentum[0]);
  EXPECT_NEAR(run->momentum()[1], momentum[1], 1e-10 * momentum[1]);
  const auto fields = run->fields();
  for (std::size_t p = 0; p < fields.phase.size(); ++p) {
    if (fields.phase[p] == no_phase) continue;
    EXPECT_NEAR(fields.displacement[p][0], velocity[0] * run->time(), 1e-9);
    EXPECT_NEAR(fields.displacement[p][1], velocity[1] * run->time(), 1e-9);
  }
}

/// Largest average stress while a body breathes that starts with a stretching velocity.
double largest_breathing_stress(const Vector<2>& drift) {
  const auto run = travelling_body([&](const Vector<2>& x) {
    return Vector<2>{drift[0] + 0.02 * (x[0] - 0.35), drift[1] + 0.02 * (x[1] - 0.35)};
  });
  std::vector<Averages<2>> averages;
  while (run->time() < 0.02) run->advance(1, averages);
  double largest = 0.0;
  for (const auto& [stress, strain] : averages) largest = std::max(largest, stress.xx);
  return largest;
}

TEST(MovingPoints, ABreathingBodyHardlyNoticesThatItCrossesCells) {
  const double at_rest = largest_breathing_stress({0.0, 0.0});
  EXPECT_NEAR(largest_breathing_stress({7.0, 3.0}) / at_rest, 1.0, 0.05);
}

TEST(MovingPoints, LeavingTheGridStopsTheRun) {
  const auto run = travelling_body([](const Vector<2>&) { return Vector<2>{-100.0, 0.0}; });
  std::vector<Averages<2>> averages;
  EXPECT_THROW(run->advance(200, averages), NumericalError);
}

/// A homogeneous cube that is strained at once as a whole has the modulus of the load as its stress, and no momentum.
TEST(ClassicalInThreeDimensions, HomogeneousCubeShowsItsModuli) {
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
      DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{3, 4, 2}, 1e-3}), {soft}};
      problem.volumetric = volumetric;
      problem.boundary = Boundary::periodic;
      problem.load = unit_strain<3>(load);
      problem.time_step = 0.5 * stable_time_step(problem.discretisation, problem.materials, volumetric, 1.0);
      problem.ramp = StrainRamp(20.0 * problem.time_step);
      dynamics::Classical<3> run(problem, 1);
      std::vector<Averages<3>> averages;
      run.advance(40, averages);
      const double modulus = (load == Load::bulk ? soft.bulk : soft.shear).equilibrium();
      EXPECT_NEAR(modulus_of(load, averages.back().stress) / modulus, 1.0, 1e-5);
      for (int index = 0; index < 6; ++index) {
        EXPECT_NEAR(component(averages.back().strain, index), component(problem.load, index), 1e-5);
      }
      const auto energy = run.energy();
      const double volume = problem.discretisation.grid().volume();
      EXPECT_NEAR(energy.strain / (0.5 * modulus * volume), 1.0, 1e-5);
      const auto fields = run.fields();
      const double pressure = load == Load::bulk ? modulus : 0.0;
      for (const auto& [xx, yy, zz, yz, zx, xy] : fields.stress) {
        EXPECT_NEAR(xx + yy + zz, 3.0 * pressure, 1e-4 * modulus);
      }
    }
  }
}

class Agreement : public testing::TestWithParam<Volumetric> {};

TEST_P(Agreement, BothFormulationsGiveTheSameModulus) {
  using testing_materials::relaxing;
  using testing_materials::stiff;
  DynamicProblem<2> problem{testing_materials::disc_in_box(20), {relaxing, stiff}};
  problem.volumetric = GetParam();
  problem.load = {.xy = 0.5};
  problem.mass_scaling = 1e-5;
  problem.ramp = StrainRamp(2e-4);
  problem.time_step = 0.5 * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, 1e-5);
  std::vector<Averages<2>> lagrangian, classical;
  const auto steps = static_cast<int>(5e-3 / problem.time_step);
  make_dynamic_solver(Formulation::total_lagrangian, problem)->advance(steps, lagrangian);
  make_dynamic_solver(Formulation::classical, problem)->advance(steps, classical);
  // Six transits of the shear wave take about 0.6 ms.
  for (auto i = static_cast<std::size_t>(steps / 5); i < static_cast<std::size_t>(steps); i += 100) {
    EXPECT_NEAR(classical[i].stress.xy / lagrangian[i].stress.xy, 1.0, 0.005);
  }
}

INSTANTIATE_TEST_SUITE_P(BothOptions, Agreement, testing::Values(Volumetric::averaged, Volumetric::standard),
                         [](const auto& chosen) {
                           return std::string(chosen.param == Volumetric::averaged ? "Averaged" : "Standard");
                         });

// A body that starts 8 cells from the right side leaves the grid long before 256 steps are over.
TEST(MovingPoints, WhichLeaveTheGridAreReportedAtTheirStep) {
  const auto leaving = [] { return travelling_body([](const Vector<2>&) { return Vector<2>{400.0, 0.0}; }); };
  int steps = 0;
  const auto one_by_one = leaving();
  std::string expected, found;
  std::vector<Averages<2>> averages;
  try {
    for (; steps < 256; ++steps) one_by_one->advance(1, averages);
  } catch (const NumericalError& error) {
    expected = error.what();
  }
  ASSERT_GT(steps, 0);
  try {
    leaving()->advance(256, averages);
  } catch (const NumericalError& error) {
    found = error.what();
  }
  EXPECT_NE(expected.find("left the grid at step " + std::to_string(steps) + ";"), std::string::npos) << expected;
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace breccia
