#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"

namespace breccia {
namespace {

using testing_materials::damped;
using testing_materials::relaxing;
using testing_materials::soft;
using testing_materials::stiff;
using testing_materials::with_step;

std::string title_of(Formulation formulation) {
  return formulation == Formulation::classical ? "Classical" : "TotalLagrangian";
}

class Boundaries : public testing::TestWithParam<std::tuple<Formulation, Volumetric>> {
 protected:
  [[nodiscard]] std::unique_ptr<DynamicSolver<2>> solver(DynamicProblem<2> problem, double courant = 0.9) const {
    problem.volumetric = std::get<Volumetric>(GetParam());
    return make_dynamic_solver(std::get<Formulation>(GetParam()), with_step(std::move(problem), courant));
  }

  /// Averages at a time [s] at which all waves have died away.
  [[nodiscard]] Averages<2> at_rest(const DynamicProblem<2>& problem, double time) const {
    const auto run = solver(problem);
    std::vector<Averages<2>> averages;
    while (run->time() < time) run->advance(100, averages);
    return averages.back();
  }
};

constexpr std::array loads = {Load::shear, Load::diagonal_shear, Load::bulk};

TEST_P(Boundaries, AHomogeneousPeriodicBoxStrainsUniformly) {
  for (const auto load : loads) {
    DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{5, 3}, 1e-3}), {soft}};
    problem.boundary = Boundary::periodic;
    problem.load = unit_strain<2>(load);
    problem.ramp = StrainRamp(1e-4);
    const auto run = solver(problem);
    std::vector<Averages<2>> averages;
    while (run->time() < 1e-3) run->advance(10, averages);
    const double expected = load == Load::bulk ? 3e6 + 1e6 / 3.0 : 1e6;
    EXPECT_NEAR(modulus_of(load, averages.back().stress) / expected, 1.0, 1e-9);
    EXPECT_NEAR(2.0 * averages.back().strain.xy, load == Load::shear ? 1.0 : 0.0, 1e-9);
    const auto momentum = run->momentum();
    // The points move by the amplitude, a millionth, so that their weights change by as much.
    EXPECT_NEAR(momentum[0], 0.0, 1e-6);
    EXPECT_NEAR(momentum[1], 0.0, 1e-6);
  }
}

TEST_P(Boundaries, APeriodicLaminateHasTheModuliOfAnEndlessOne) {
  const std::vector<Material> materials = {damped(2e6, 0.3e6), damped(5e6, 3e6)};
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{5, 8}, 0.125}), materials};
  problem.discretisation.paint([](const Vector<2>& x) { return x[1] > 0.25 && x[1] < 0.5; }, 1);
  problem.boundary = Boundary::periodic;
  problem.ramp = StrainRamp(0.1);
  const std::array<double, 2> share = {0.75, 0.25};

  // In shear along the layers the stress is the same in all of them.
  problem.load = unit_strain<2>(Load::shear);
  const double series = 1.0 / (share[0] / 0.3e6 + share[1] / 3e6);
  EXPECT_NEAR(modulus_of(Load::shear, at_rest(problem, 4.0).stress) / series, 1.0, 1e-5);

  // Stretched along the layers by e, their strain along x and their stress along y are the same:
  // s = lambda e + m strain_y in each, m = lambda + 2 G, and the mean of strain_y is given.
  for (const auto load : {Load::diagonal_shear, Load::bulk}) {
    problem.load = unit_strain<2>(load);
    const double e = problem.load.xx;
    double strain = problem.load.yy, inverse = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double shear = materials[i].shear.equilibrium(), lambda = materials[i].bulk.equilibrium() - shear / 1.5;
      strain += share[i] * lambda * e / (lambda + 2.0 * shear);
      inverse += share[i] / (lambda + 2.0 * shear);
    }
    Stress<2> exact{.yy = strain / inverse};
    for (std::size_t i = 0; i < 2; ++i) {
      const double shear = materials[i].shear.equilibrium(), lambda = materials[i].bulk.equilibrium() - shear / 1.5;
      const double strain_y = (exact.yy - lambda * e) / (lambda + 2.0 * shear);
      exact.xx += share[i] * ((lambda + 2.0 * shear) * e + lambda * strain_y);
    }
    EXPECT_NEAR(modulus_of(load, at_rest(problem, 4.0).stress) / modulus_of(load, exact), 1.0, 1e-5);
  }
}

TEST_P(Boundaries, TractionDeformsAHomogeneousBoxByItsCompliance) {
  for (const auto load : loads) {
    DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{5, 3}, 0.1}), {damped(2e6, 0.3e6)}};
    problem.boundary = Boundary::traction;
    problem.traction = unit_stress<2>(load);
    problem.ramp = StrainRamp(0.1);
    const auto averages = at_rest(problem, 4.0);
    const double modulus = load == Load::bulk ? 2e6 + 0.1e6 : 0.3e6;
    EXPECT_NEAR(compliance_of(load, averages.strain) * modulus, 1.0, 1e-5);
    EXPECT_NEAR(modulus_of(load, averages.stress), 1.0, 1e-5);
  }
}

TEST_P(Boundaries, TractionShearsALaminateByTheMeanCompliance) {
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{5, 8}, 0.125}), {damped(2e6, 0.3e6), damped(5e6, 3e6)}};
  problem.discretisation.paint([](const Vector<2>& x) { return x[1] > 0.25 && x[1] < 0.5; }, 1);
  problem.boundary = Boundary::traction;
  problem.traction = unit_stress<2>(Load::shear);
  problem.ramp = StrainRamp(0.1);
  const double compliance = compliance_of(Load::shear, at_rest(problem, 6.0).strain);
  EXPECT_NEAR(compliance / (0.75 / 0.3e6 + 0.25 / 3e6), 1.0, 1e-5);
}

TEST_P(Boundaries, CreepsAsAStandardLinearSolid) {
  // J(t) = 1/G_inf - (1/G_inf - 1/G_0) exp(-t / lambda), lambda = tau G_0 / G_inf.
  const double slow = 0.5, relaxed = 0.2e6, unrelaxed = 1e6;
  const double retardation = slow * unrelaxed / relaxed;
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{4, 4}, 1e-3}),
                            {{"solid", 1000.0, PronySeries(3e6), PronySeries(relaxed, {{slow, unrelaxed - relaxed}})}}};
  problem.boundary = Boundary::traction;
  problem.traction = unit_stress<2>(Load::shear);
  problem.mass_scaling = 400.0;
  problem.ramp = StrainRamp(0.05);
  const auto run = solver(problem);
  std::vector<Averages<2>> averages;
  while (run->time() < 3.0) {
    averages.clear();
    const double time = run->time();
    run->advance(1, averages);
    if (time < 0.2) continue;
    const double exact = 1.0 / relaxed - (1.0 / relaxed - 1.0 / unrelaxed) * std::exp(-time / retardation);
    ASSERT_NEAR(compliance_of(Load::shear, averages.back().strain) / exact, 1.0, 3e-4) << "at " << time;
  }
}

TEST_P(Boundaries, ABodyUnderTractionNeitherDriftsNorTurns) {
  const bool lagrangian = std::get<Formulation>(GetParam()) == Formulation::total_lagrangian;
  for (const auto load : loads) {
    DynamicProblem<2> problem{testing_materials::disc_in_box(8), {relaxing, stiff}};
    problem.boundary = Boundary::traction;
    problem.traction = unit_stress<2>(load);
    problem.ramp = StrainRamp(0.05);
    const auto run = solver(problem);
    std::vector<Averages<2>> averages;
    run->advance(lagrangian ? 100000 : 10000, averages);
    const auto fields = run->fields();
    double largest = 0.0, turn = 0.0, weight = 0.0;
    Vector<2> drift = {0.0, 0.0};
    for (int i = 0; i < 256; ++i) {
      const int column = i % 16, row = i / 16;
      const double x = (column - 7.5) / 16.0, y = (row - 7.5) / 16.0;
      const double mass = fields.phase[static_cast<std::size_t>(i)] == 0 ? relaxing.density : stiff.density;
      const auto& [u, v] = fields.displacement[static_cast<std::size_t>(i)];
      largest = std::max({largest, std::abs(u), std::abs(v)});
      drift[0] += mass * u;
      drift[1] += mass * v;
      turn += mass * (x * v - y * u);
      weight += mass;
    }
    EXPECT_LT(std::abs(drift[0]) / weight, 1e-9 * largest);
    EXPECT_LT(std::abs(drift[1]) / weight, 1e-9 * largest);
    // The nodes conserve their angular momentum; the points weight the displacements slightly differently.
    EXPECT_LT(std::abs(turn) / weight, 1e-2 * largest);
  }
}

TEST_P(Boundaries, APeriodicBoxConservesMomentum) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(12), {relaxing, stiff}};
  problem.boundary = Boundary::periodic;
  const auto run = solver(problem);
  run->set_velocities([](const Vector<2>& x) { return Vector<2>{1.0 + std::sin(40.0 * x[0]), std::cos(30.0 * x[1])}; });
  const auto before = run->momentum();
  std::vector<Averages<2>> averages;
  run->advance(500, averages);
  EXPECT_NEAR(run->momentum()[0], before[0], 1e-8);
  EXPECT_NEAR(run->momentum()[1], before[1], 1e-8);
}

TEST_P(Boundaries, GiveTheSameBitsForAnyNumberOfThreads) {
  const auto [formulation, volumetric] = GetParam();
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    // Enough points for five threads.
    const int cells = formulation == Formulation::classical ? 72 : 131;
    DynamicProblem<2> problem{testing_materials::disc_in_box(cells), {relaxing, stiff}};
    problem.volumetric = volumetric;
    problem.boundary = boundary;
    problem.load = {.xx = 0.1, .yy = -0.2, .xy = 0.5};
    problem.traction = {.xx = 0.2, .yy = -0.4, .xy = 1.0};
    problem.ramp = StrainRamp(1e-3);
    std::vector<Averages<2>> alone;
    make_dynamic_solver(formulation, with_step(problem), 1)->advance(20, alone);
    for (const int threads : {2, 3, 5}) {
      std::vector<Averages<2>> together;
      const auto run = make_dynamic_solver(formulation, with_step(problem), threads);
      run->advance(13, together);
      run->advance(7, together);
      EXPECT_EQ(together, alone) << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Boundaries,
                         testing::Combine(testing::Values(Formulation::total_lagrangian, Formulation::classical),
                                          testing::Values(Volumetric::averaged, Volumetric::standard)),
                         [](const auto& chosen) {
                           return title_of(std::get<0>(chosen.param)) +
                                  (std::get<1>(chosen.param) == Volumetric::averaged ? "Averaged" : "Standard");
                         });

class EveryBoundary : public testing::TestWithParam<Boundary> {};

TEST_P(EveryBoundary, GivesTheSameBitsOnEveryInstructionSet) {
  for (const int cells : {37, 40}) {  // 40 fill whole blocks
    DynamicProblem<2> problem{testing_materials::disc_in_box(cells), {relaxing, stiff}};
    problem.boundary = GetParam();
    problem.load = {.xx = 0.5, .yy = 0.5};
    problem.traction = {.xx = 1.0, .yy = 1.0};
    problem.ramp = StrainRamp(1e-3);
    const auto run = [&](InstructionSet instructions) {
      std::vector<Averages<2>> averages;
      make_dynamic_solver(Formulation::total_lagrangian, with_step(problem), 0, instructions)->advance(300, averages);
      return averages;
    };
    const auto baseline = run(InstructionSet::baseline);
    for (const auto set : supported_instruction_sets()) EXPECT_EQ(run(set), baseline) << name_of(set);
  }
}

TEST_P(EveryBoundary, BothFormulationsAgree) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(16), {relaxing, stiff}};
  problem.boundary = GetParam();
  problem.load = {.xx = 0.2, .yy = -0.1, .xy = 0.5};
  problem.traction = {.xx = 0.4, .yy = -0.2, .xy = 1.0};
  problem.mass_scaling = 1e-5;
  problem.ramp = StrainRamp(6e-4);
  problem = with_step(problem, 0.5);
  std::vector<Averages<2>> lagrangian, classical;
  const auto steps = static_cast<int>(5e-3 / problem.time_step);
  make_dynamic_solver(Formulation::total_lagrangian, problem)->advance(steps, lagrangian);
  make_dynamic_solver(Formulation::classical, problem)->advance(steps, classical);
  for (auto i = static_cast<std::size_t>(steps / 4); i < static_cast<std::size_t>(steps); i += 100) {
    EXPECT_NEAR(classical[i].stress.xy / lagrangian[i].stress.xy, 1.0, 0.005);
    EXPECT_NEAR(classical[i].strain.xx / lagrangian[i].strain.xx, 1.0, 0.005);
    EXPECT_NEAR(classical[i].strain.xy / lagrangian[i].strain.xy, 1.0, 0.005);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryBoundary,
                         testing::Values(Boundary::displacement, Boundary::traction, Boundary::periodic),
                         [](const auto& chosen) {
                           return std::string(chosen.param == Boundary::displacement ? "Displacement"
                                              : chosen.param == Boundary::traction   ? "Traction"
                                                                                     : "Periodic");
                         });

TEST(PeriodicBox, WhereItsEdgeLiesMakesNoDifference) {
  // The stress of a laminate in two directions, shifted by a few cells across both edges, does not change.
  const auto stress = [](int shift) {
    DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{12, 12}, 1.0 / 12}), {relaxing, stiff}};
    problem.discretisation.paint(
        [&](const Vector<2>& x) {
          const auto shifted = [&](double along) { return std::fmod(along + shift / 12.0, 1.0); };
          return shifted(x[0]) < 0.5 && shifted(x[1]) < 0.4;
        },
        1);
    problem.boundary = Boundary::periodic;
    problem.load = {.xx = 0.1, .yy = -0.2, .xy = 0.5};
    problem.traction = {.xx = 0.2, .yy = -0.4, .xy = 1.0};
    problem.ramp = StrainRamp(1e-3);
    std::vector<Averages<2>> averages;
    make_dynamic_solver(Formulation::total_lagrangian, with_step(problem))->advance(600, averages);
    return averages.back().stress;
  };
  const auto here = stress(0), there = stress(5);
  EXPECT_NEAR(there.xx / here.xx, 1.0, 1e-10);
  EXPECT_NEAR(there.yy / here.yy, 1.0, 1e-10);
  EXPECT_NEAR(there.xy / here.xy, 1.0, 1e-10);
}

TEST(PeriodicBox, AnElasticOneConservesItsEnergy) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(12), {soft, stiff}};
  problem.boundary = Boundary::periodic;
  const auto run = make_dynamic_solver(Formulation::total_lagrangian, with_step(problem, 0.99));
  run->set_velocities([](const Vector<2>& x) { return Vector<2>{std::sin(40.0 * x[0]), std::cos(30.0 * x[1])}; });
  std::vector<Averages<2>> averages;
  run->advance(1, averages);
  const auto total = [&] { return run->energy().kinetic + run->energy().strain; };
  const double before = total();
  run->advance(5000, averages);
  EXPECT_NEAR(total() / before, 1.0, 1e-10);
}

TEST(PeriodicBox, MovingPointsThatLeaveItComeBack) {
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{8, 8}, 0.125}), {soft}};
  problem.boundary = Boundary::periodic;
  problem.amplitude = 1.0;
  const auto run = make_dynamic_solver(Formulation::classical, with_step(problem, 0.3));
  run->set_velocities([](const Vector<2>&) { return Vector<2>{6.0, -4.0}; });
  const auto momentum = run->momentum();
  std::vector<Averages<2>> averages;
  while (run->time() < 0.3) run->advance(1, averages);  // the body crosses the box nearly twice
  for (const auto& [stress, strain] : averages) EXPECT_NEAR(stress.xx, 0.0, 1e-6);
  EXPECT_NEAR(run->momentum()[0], momentum[0], 1e-9 * momentum[0]);
  const auto fields = run->fields();
  for (const auto& [u, v] : fields.displacement) {
    EXPECT_NEAR(u, 6.0 * run->time(), 1e-9);
    EXPECT_NEAR(v, -4.0 * run->time(), 1e-9);
  }
}

TEST(TractionBoundary, RefusesALoadWhereThereAreNoPoints) {
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{8, 8}, 0.125}, no_phase), {soft}};
  problem.discretisation.paint([](const Vector<2>& x) { return x[0] < 0.7; }, 0);
  problem.boundary = Boundary::traction;
  EXPECT_NO_THROW(make_dynamic_solver(Formulation::total_lagrangian, with_step(problem)));
  problem.traction = unit_stress<2>(Load::shear);
  EXPECT_THROW(make_dynamic_solver(Formulation::total_lagrangian, with_step(problem)), InputError);
}

}  // namespace
}  // namespace breccia
