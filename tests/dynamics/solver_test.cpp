#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using testing_materials::damped;
using testing_materials::relaxing;
using testing_materials::soft;
using testing_materials::stiff;
using testing_materials::with_step;

/// Irregular velocities that depend only on the position.
Vector<2> scattered(const Vector<2>& position) {
  const double phase = 1e4 * position[0] + 3e4 * position[1] * position[1];
  return {std::sin(phase), std::cos(1.7 * phase)};
}

class BothFormulations : public testing::TestWithParam<std::tuple<Formulation, Volumetric>> {
 protected:
  [[nodiscard]] std::unique_ptr<DynamicSolver<2>> solver(DynamicProblem<2> problem, double courant = 0.9) const {
    problem.volumetric = std::get<Volumetric>(GetParam());
    return make_dynamic_solver(std::get<Formulation>(GetParam()), with_step(std::move(problem), courant));
  }
};

/// Response of one Maxwell element after a raised-cosine ramp of duration T, per unit modulus (theory, Eq. 13).
double ramped_exponential(double t, double relaxation_time, double duration) {
  const double a = 0.5 * duration / relaxation_time;
  const double k = std::numbers::pi;
  return std::exp(-t / relaxation_time) * std::sinh(a) / a * k * k / (a * a + k * k);
}

TEST_P(BothFormulations, OneHomogeneousCellRelaxesExactlyInShearAndBulk) {
  const double duration = 2e-3;
  for (const auto& load : {Strain<2>{.xy = 0.5}, Strain<2>{.xx = 0.5, .yy = 0.5}}) {
    DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{1, 1}, 1e-3}), {relaxing}};
    problem.load = load;
    problem.ramp = StrainRamp(duration);
    const auto run = solver(problem, 0.5);
    std::vector<Averages<2>> averages;
    while (run->time() < 5e-3) run->advance(100, averages);
    const double t = run->time();
    run->advance(1, averages);
    const auto modulus = [&](const PronySeries& series) {
      double sum = series.equilibrium();
      for (const auto& [time, m] : series.terms()) sum += m * ramped_exponential(t, time, duration);
      return sum;
    };
    const bool shear = load.xy != 0.0;
    const double expected = shear ? modulus(relaxing.shear) : modulus(relaxing.bulk) + modulus(relaxing.shear) / 3.0;
    const double found =
        shear ? averages.back().stress.xy : 0.5 * (averages.back().stress.xx + averages.back().stress.yy);
    EXPECT_NEAR(found / expected, 1.0, 1e-6);
  }
}

TEST_P(BothFormulations, UniformStrainIsASolutionOfAnyHomogeneousBox) {
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{8, 8}, 0.125}), {soft}};
  problem.load = {.xx = 0.3, .yy = -0.1, .xy = 0.2};
  problem.ramp = StrainRamp(0.1);
  problem.start = Start::affine;
  const auto run = solver(problem);
  std::vector<Averages<2>> averages;
  while (run->time() < 0.06) run->advance(1, averages);
  const double lambda = 3e6 - 2e6 / 3.0, twice_shear = 2e6;
  const auto fields = run->fields();
  for (std::size_t p = 0; p < fields.stress.size(); ++p) {
    EXPECT_NEAR(fields.strain[p][0], 0.3, 1e-9);
    EXPECT_NEAR(fields.strain[p][2], 0.2, 1e-9);
    EXPECT_NEAR(fields.stress[p][0], lambda * 0.2 + twice_shear * 0.3, 1e-2);
    EXPECT_NEAR(fields.stress[p][1], lambda * 0.2 - twice_shear * 0.1, 1e-2);
    EXPECT_NEAR(fields.stress[p][2], lambda * 0.2, 1e-2);
    EXPECT_NEAR(fields.stress[p][3], twice_shear * 0.2, 1e-2);
  }
  // The lower left point lies at (h/4, h/4), and the centre of the box, at (1/2, 1/2), rests.
  const double from_centre = 0.125 / 4 - 0.5;
  EXPECT_NEAR(fields.displacement[0][0], (0.3 + 0.2) * from_centre, 1e-6);
  EXPECT_NEAR(fields.displacement[0][1], (0.2 - 0.1) * from_centre, 1e-6);
}

TEST_P(BothFormulations, ConserveTheMomentumOfAFreeBody) {
  DynamicProblem<2> problem{testing_materials::disc_in_box(12), {relaxing, stiff}};
  problem.boundary = Boundary::traction;
  const auto run = solver(problem);
  run->set_velocities(scattered);
  const auto before = run->momentum();
  std::vector<Averages<2>> averages;
  run->advance(500, averages);
  const auto after = run->momentum();
  const double scale = 1000.0;  // mass of the body times a typical velocity
  EXPECT_NEAR(after[0], before[0], 1e-11 * scale);
  EXPECT_NEAR(after[1], before[1], 1e-11 * scale);
}

TEST_P(BothFormulations, ConserveTheEnergyOfAnElasticFreeBody) {
  const bool lagrangian = std::get<Formulation>(GetParam()) == Formulation::total_lagrangian;
  DynamicProblem<2> problem{testing_materials::disc_in_box(12), {soft, stiff}};
  problem.boundary = Boundary::traction;
  const auto run = solver(problem, lagrangian ? 0.99 : 0.2);
  // Central differences conserve the energy for any motion; "update strain average" does so for motions that the grid
  // resolves.
  if (lagrangian) {
    run->set_velocities(scattered);
  } else {
    run->set_velocities([](const Vector<2>& x) {
      return Vector<2>{std::cos(std::numbers::pi * x[0]), 0.5 * std::cos(std::numbers::pi * x[1])};
    });
  }
  std::vector<Averages<2>> averages;
  run->advance(1, averages);
  const auto total = [&] { return run->energy().kinetic + run->energy().strain; };
  const double before = total();
  run->advance(lagrangian ? 5000 : 500, averages);
  EXPECT_NEAR(total() / before, 1.0, lagrangian ? 1e-10 : 0.02);
  EXPECT_GT(run->energy().strain, 0.01 * before);
}

TEST_P(BothFormulations, StopWithStepAndPlaceWhenTheyAreUnstable) {
  const bool lagrangian = std::get<Formulation>(GetParam()) == Formulation::total_lagrangian;
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{4, 4}, 0.25}), {soft}};
  problem.boundary = Boundary::traction;
  const auto run = solver(problem);
  run->set_velocities([](const Vector<2>& x) { return Vector<2>{x[0] > 0.5 ? 1e308 : -1e308, 0.0}; });
  std::vector<Averages<2>> averages;
  // Material points of the classical formulation move, and leave the grid before a number overflows.
  const auto* const expected = lagrangian ? "unstable at step [0-9]+, .* s after the load.* motion at .* m; likely "
                                          : "the point .* m left the grid at step [0-9]+; likely cause: ";
  EXPECT_THAT(test::message_of<NumericalError>([&] { run->advance(100, averages); }), testing::ContainsRegex(expected));
}

TEST_P(BothFormulations, GiveNoEnergyOfRelaxingMaterials) {
  EXPECT_THROW((void)solver({Discretisation<2>(Grid<2>{{2, 2}, 0.5}), {relaxing}})->energy(), InputError);
}

INSTANTIATE_TEST_SUITE_P(All, BothFormulations,
                         testing::Combine(testing::Values(Formulation::total_lagrangian, Formulation::classical),
                                          testing::Values(Volumetric::averaged, Volumetric::standard)),
                         [](const auto& chosen) {
                           return std::string(std::get<Formulation>(chosen.param) == Formulation::classical
                                                  ? "Classical"
                                                  : "TotalLagrangian") +
                                  (std::get<Volumetric>(chosen.param) == Volumetric::averaged ? "Averaged"
                                                                                              : "Standard");
                         });

TEST(TotalLagrangian, HoldsFiveNumbersPerCellAndShearTerm) {
  const auto footprint = [](const std::vector<MaxwellTerm>& terms) {
    const Material material{"material", 1e3, PronySeries(1e9), PronySeries(1e6, terms)};
    return make_dynamic_solver(Formulation::total_lagrangian,
                               with_step<2>({Discretisation<2>(Grid<2>{{16, 12}, 0.1}), {material}}))
        ->footprint();
  };
  const auto without = footprint({}), with = footprint({{1.0, 1e6}, {2.0, 1e6}});
  const std::size_t history = 2 * 5 * sizeof(double) * 16 * 12;
  EXPECT_EQ(with.held - without.held, history);
  EXPECT_EQ(with.moved_per_step - without.moved_per_step, 2 * history);
}

TEST(TotalLagrangian, RefusesAnUnknownInstructionSet) {
  setenv("BRECCIA_INSTRUCTION_SET", "mmx", 1);
  EXPECT_THROW(make_dynamic_solver(Formulation::total_lagrangian,
                                   with_step<2>({Discretisation<2>(Grid<2>{{2, 2}, 0.5}), {soft}})),
               InputError);
  unsetenv("BRECCIA_INSTRUCTION_SET");
}

/// Average stress per unit load in the long-time limit of a box of layers stacked in y.
Stress<2> relaxed_laminate(int columns, const std::vector<Material>& materials, const Strain<2>& load) {
  constexpr int rows = 16;
  const double h = 1.0 / rows;
  DynamicProblem<2> problem{Discretisation<2>(Grid<2>{{columns, rows}, h}), materials};
  problem.discretisation.paint([](const Vector<2>& point) { return point[1] > 0.5; }, 1);
  problem.load = load;
  problem.ramp = StrainRamp(1.0);
  problem.start = Start::affine;
  const auto run = make_dynamic_solver(Formulation::total_lagrangian, with_step(problem));
  std::vector<Averages<2>> averages;
  while (run->time() < 40.0) run->advance(100, averages);
  return averages.back().stress;
}

TEST(Laminate, InParallelItsModuliAddUp) {
  // Layers with the same Lame modulus K - 2 G / 3 strain uniformly along the layers: sigma_xx = sum of f (lambda + 2
  // G).
  const double lambda = 1e6;
  const auto material = [&](double shear) { return damped(lambda + 2.0 / 3.0 * shear, shear); };
  const auto stress = relaxed_laminate(32, {material(0.3e6), material(3e6)}, {.xx = 1.0});
  EXPECT_NEAR(stress.xx / (lambda + 2.0 * 1.65e6), 1.0, 1e-3);
}

TEST(Laminate, InSeriesItsCompliancesAddUp) {
  // The sides hold the layers back near the ends of the box; the effect is inversely proportional to the length of the
  // box.
  const std::vector<Material> materials = {damped(1e6, 0.3e6), damped(5e6, 3e6)};
  const auto modulus = [&](int columns) { return relaxed_laminate(columns, materials, {.xy = 0.5}).xy; };
  const double endless = 2.0 * modulus(128) - modulus(64);
  EXPECT_NEAR(endless / (2.0 / (1.0 / 0.3e6 + 1.0 / 3e6)), 1.0, 0.01);
}

}  // namespace
}  // namespace breccia
