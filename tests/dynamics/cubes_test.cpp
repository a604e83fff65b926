// Tests of both formulations in three dimensions.
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
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
using testing_materials::mixed_sphere_in_box;
using testing_materials::relaxing;
using testing_materials::soft;
using testing_materials::sphere_in_box;
using testing_materials::stiff;
using testing_materials::with_step;

constexpr std::array loads_of_space = {Load::shear,    Load::diagonal_shear, Load::bulk,
                                       Load::shear_yz, Load::shear_zx,       Load::diagonal_shear_yz};

double modulus_under(Load load, double bulk, double shear) {
  return load == Load::bulk ? bulk : shear;
}

/// A strain whose components are all different and not zero.
constexpr Strain<3> some_strain = {.xx = 0.1, .yy = -0.2, .zz = 0.15, .yz = 0.3, .zx = -0.25, .xy = 0.5};
constexpr Stress<3> some_stress = {.xx = 0.2, .yy = -0.4, .zz = 0.3, .yz = 0.5, .zx = -0.6, .xy = 1.0};

class Cubes : public testing::TestWithParam<std::tuple<Formulation, Volumetric>> {
 protected:
  [[nodiscard]] std::unique_ptr<DynamicSolver<3>> solver(DynamicProblem<3> problem, double courant = 0.9) const {
    problem.volumetric = std::get<Volumetric>(GetParam());
    return make_dynamic_solver(std::get<Formulation>(GetParam()), with_step(std::move(problem), courant));
  }

  /// Averages at a time [s] at which all waves have died away.
  [[nodiscard]] Averages<3> at_rest(const DynamicProblem<3>& problem, double time) const {
    const auto run = solver(problem);
    std::vector<Averages<3>> averages;
    while (run->time() < time) run->advance(20, averages);
    return averages.back();
  }
};

TEST_P(Cubes, AHomogeneousPeriodicBoxStrainsUniformly) {
  for (const auto load : loads_of_space) {
    DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{5, 3, 4}, 1e-3}), {soft}};
    problem.boundary = Boundary::periodic;
    problem.load = unit_strain<3>(load);
    problem.ramp = StrainRamp(1e-4);
    const auto run = solver(problem);
    std::vector<Averages<3>> averages;
    while (run->time() < 2e-4) run->advance(10, averages);
    EXPECT_NEAR(modulus_of(load, averages.back().stress) / modulus_under(load, 3e6, 1e6), 1.0, 1e-8);
    for (const double along : run->momentum()) EXPECT_NEAR(along, 0.0, 1e-6);
  }
}

TEST_P(Cubes, TractionDeformsAHomogeneousBoxByItsCompliance) {
  for (const auto load : {Load::shear_zx, Load::diagonal_shear_yz, Load::bulk}) {
    DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{3, 2, 4}, 0.1}), {damped(2e6, 0.3e6)}};
    problem.boundary = Boundary::traction;
    problem.traction = unit_stress<3>(load);
    problem.mass_scaling = 0.1;
    problem.ramp = StrainRamp(0.1);
    const auto averages = at_rest(problem, 1.0);
    EXPECT_NEAR(compliance_of(load, averages.strain) * modulus_under(load, 2e6, 0.3e6), 1.0, 1e-4);
    EXPECT_NEAR(modulus_of(load, averages.stress), 1.0, 1e-4);
  }
}

TEST_P(Cubes, UniformStrainIsASolutionOfAnyHomogeneousBox) {
  DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{4, 3, 2}, 0.125}), {soft}};
  problem.load = some_strain;
  problem.ramp = StrainRamp(0.1);
  problem.start = Start::affine;
  const auto run = solver(problem);
  std::vector<Averages<3>> averages;
  while (run->time() < 0.06) run->advance(1, averages);
  const double lambda = 3e6 - 2e6 / 3.0, twice_shear = 2e6, trace = 0.05;
  const auto fields = run->fields();
  for (std::size_t p = 0; p < fields.stress.size(); ++p) {
    for (int i = 0; i < 6; ++i) {
      const auto index = static_cast<std::size_t>(i);
      EXPECT_NEAR(fields.strain[p][index], component(some_strain, i), 1e-9);
      EXPECT_NEAR(fields.stress[p][index], (i < 3 ? lambda * trace : 0.0) + twice_shear * component(some_strain, i),
                  1e-2);
    }
  }
  // The fields are means over cells, whose first one has its centre at h/2; the centre of the box rests.
  const Vector<3> from_centre = {0.125 / 2 - 0.25, 0.125 / 2 - 0.1875, 0.125 / 2 - 0.125};
  const auto moved = product(some_strain, from_centre);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(fields.displacement[0][i], moved[i], 1e-6);
}

TEST_P(Cubes, RelaxLikeTheirMaterialInShearAndBulk) {
  for (const auto load : {Load::shear_yz, Load::bulk}) {
    DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{2, 3, 2}, 2e-4}), {relaxing}};
    problem.boundary = Boundary::periodic;
    problem.load = unit_strain<3>(load);
    problem.ramp = StrainRamp(1e-5);
    const auto run = solver(problem);
    std::vector<Averages<3>> averages;
    while (run->time() < 1e-3) run->advance(1, averages);
    const auto& modulus = load == Load::bulk ? relaxing.bulk : relaxing.shear;
    const double time = run->time() - problem.time_step;
    EXPECT_NEAR(modulus_of(load, averages.back().stress) / modulus.at(time), 1.0, 2e-2);
    // The box strains uniformly, so that every cell has the stress of a relaxing point, and no other component.
    const auto fields = run->fields();
    for (const auto& [xx, yy, zz, yz, zx, xy] : fields.stress) {
      const Stress<3> stress = {.xx = xx, .yy = yy, .zz = zz, .yz = yz, .zx = zx, .xy = xy};
      EXPECT_NEAR(modulus_of(load, stress) / modulus.at(run->time()), 1.0, 2e-2);
      const double normal = load == Load::bulk ? modulus_of(load, stress) : 0.0;
      const double largest = 1e-6 * modulus.unrelaxed();
      for (const double along : {xx, yy, zz}) EXPECT_NEAR(along, normal, largest);
      for (const double across : {zx, xy}) EXPECT_NEAR(across, 0.0, largest);
    }
  }
}

TEST_P(Cubes, ConserveTheMomentumOfAFreeBodyAndOfAPeriodicBox) {
  for (const auto boundary : {Boundary::traction, Boundary::periodic}) {
    DynamicProblem<3> problem{sphere_in_box(5), {relaxing, stiff}};
    problem.boundary = boundary;
    const auto run = solver(problem);
    run->set_velocities([](const Vector<3>& x) {
      return Vector<3>{1.0 + std::sin(40.0 * x[0]), std::cos(30.0 * x[1]), std::sin(20.0 * x[2] + x[0])};
    });
    const auto before = run->momentum();
    std::vector<Averages<3>> averages;
    run->advance(100, averages);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(run->momentum()[i], before[i], 1e-8);
  }
}

TEST_P(Cubes, GiveTheSameBitsForAnyNumberOfThreads) {
  const auto [formulation, volumetric] = GetParam();
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    // Enough points for three threads.
    const int cells = formulation == Formulation::classical ? 12 : 15;
    DynamicProblem<3> problem{sphere_in_box(cells), {relaxing, stiff}};
    problem.volumetric = volumetric;
    problem.boundary = boundary;
    problem.load = some_strain;
    problem.traction = some_stress;
    problem.ramp = StrainRamp(1e-3);
    std::vector<Averages<3>> alone;
    make_dynamic_solver(formulation, with_step(problem), 1)->advance(6, alone);
    for (const int threads : {2, 3}) {
      std::vector<Averages<3>> together;
      const auto run = make_dynamic_solver(formulation, with_step(problem), threads);
      run->advance(4, together);
      run->advance(2, together);
      EXPECT_EQ(together, alone) << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Cubes,
                         testing::Combine(testing::Values(Formulation::total_lagrangian, Formulation::classical),
                                          testing::Values(Volumetric::averaged, Volumetric::standard)),
                         [](const auto& chosen) {
                           const bool lagrangian = std::get<0>(chosen.param) == Formulation::total_lagrangian;
                           return std::string(lagrangian ? "TotalLagrangian" : "Classical") +
                                  (std::get<1>(chosen.param) == Volumetric::averaged ? "Averaged" : "Standard");
                         });

class CubesUnderEveryBoundary : public testing::TestWithParam<Boundary> {
 protected:
  [[nodiscard]] DynamicProblem<3> loaded(DynamicProblem<3> problem) const {
    problem.boundary = GetParam();
    problem.load = some_strain;
    problem.traction = some_stress;
    return problem;
  }
};

TEST_P(CubesUnderEveryBoundary, GiveTheSameBitsOnEveryInstructionSet) {
  auto problem = loaded(mixed_sphere_in_box(11, {relaxing, stiff}));
  problem.ramp = StrainRamp(1e-3);
  const auto run = [&](InstructionSet instructions) {
    std::vector<Averages<3>> averages;
    make_dynamic_solver(Formulation::total_lagrangian, with_step(problem), 0, instructions)->advance(60, averages);
    return averages;
  };
  const auto baseline = run(InstructionSet::baseline);
  for (const auto set : supported_instruction_sets()) EXPECT_EQ(run(set), baseline) << name_of(set);
}

// The test compares single samples of runs that still ring; SphereInACube compares curves.
TEST_P(CubesUnderEveryBoundary, BothFormulationsAgree) {
  auto problem = loaded({sphere_in_box(6), {relaxing, stiff}});
  problem.mass_scaling = 3e-4;
  problem.ramp = StrainRamp(1e-3);
  problem = with_step(problem, 0.5);
  std::vector<Averages<3>> lagrangian, classical;
  const auto steps = static_cast<int>(4e-3 / problem.time_step);
  make_dynamic_solver(Formulation::total_lagrangian, problem)->advance(steps, lagrangian);
  make_dynamic_solver(Formulation::classical, problem)->advance(steps, classical);
  for (auto i = static_cast<std::size_t>(steps / 4); i < static_cast<std::size_t>(steps); i += 20) {
    EXPECT_NEAR(classical[i].stress.xy / lagrangian[i].stress.xy, 1.0, 0.01);
    EXPECT_NEAR(classical[i].stress.yz / lagrangian[i].stress.yz, 1.0, 0.01);
    EXPECT_NEAR(classical[i].strain.zx / lagrangian[i].strain.zx, 1.0, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CubesUnderEveryBoundary,
                         testing::Values(Boundary::displacement, Boundary::traction, Boundary::periodic),
                         [](const auto& chosen) {
                           return std::string(chosen.param == Boundary::displacement ? "Displacement"
                                              : chosen.param == Boundary::traction   ? "Traction"
                                                                                     : "Periodic");
                         });

/// A cyclic change of the axes: x to y, y to z, z to x.
Vector<3> turned(const Vector<3>& x) {
  return {x[2], x[0], x[1]};
}

TEST(CubicBoxes, OfLayersAcrossAnyAxisHaveTheSeriesModulusInShearAlongThem) {
  const std::vector<Material> materials = {damped(2e6, 0.3e6), damped(5e6, 3e6)};
  const double series = 1.0 / (0.75 / 0.3e6 + 0.25 / 3e6);
  constexpr std::array<Load, 3> along = {Load::shear, Load::shear_yz, Load::shear_zx};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Grid<3> grid{{2, 2, 2}, 0.25};
    grid.cells[axis] = 4;
    DynamicProblem<3> problem{Discretisation<3>(grid), materials};
    problem.discretisation.paint([axis](const Vector<3>& x) { return x[axis] > 0.25 && x[axis] < 0.5; }, 1);
    problem.boundary = Boundary::periodic;
    problem.load = unit_strain<3>(along[axis]);
    problem.ramp = StrainRamp(0.1);
    const auto run = make_dynamic_solver(Formulation::total_lagrangian, with_step(problem));
    std::vector<Averages<3>> averages;
    while (run->time() < 4.0) run->advance(100, averages);
    EXPECT_NEAR(modulus_of(along[axis], averages.back().stress) / series, 1.0, 1e-5) << "axis " << axis;
  }
}

TEST(CubicBoxes, TurnedWithTheirLoadHaveTheStressTurned) {
  const auto stress = [](bool is_turned, Boundary boundary) {
    DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{7, 7, 7}, 1.0 / 7}), {relaxing, stiff}};
    problem.discretisation.paint(
        [is_turned](const Vector<3>& position) {
          const auto x = is_turned ? position : turned(turned(position));
          return x[0] < 0.6 && x[1] < 0.3 && x[2] > 0.2;
        },
        1);
    problem.boundary = boundary;
    const auto& e = some_strain;
    problem.load = is_turned ? e : Strain<3>{e.zz, e.xx, e.yy, e.xy, e.yz, e.zx};
    problem.ramp = StrainRamp(1e-3);
    std::vector<Averages<3>> averages;
    make_dynamic_solver(Formulation::total_lagrangian, with_step(problem))->advance(100, averages);
    return averages.back().stress;
  };
  for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
    const auto one = stress(true, boundary), other = stress(false, boundary);
    const std::array<std::pair<double, double>, 6> pairs = {{{one.zz, other.xx},
                                                             {one.xx, other.yy},
                                                             {one.yy, other.zz},
                                                             {one.xy, other.yz},
                                                             {one.yz, other.zx},
                                                             {one.zx, other.xy}}};
    for (const auto& [is, turned_back] : pairs) EXPECT_NEAR(turned_back / is, 1.0, 1e-10);
  }
}

TEST(CubicBoxes, OfElasticMaterialsConserveTheirEnergyUpToTheStableStep) {
  for (const auto boundary : {Boundary::traction, Boundary::periodic}) {
    DynamicProblem<3> problem{sphere_in_box(6), {soft, stiff}};
    problem.boundary = boundary;
    const auto run = make_dynamic_solver(Formulation::total_lagrangian, with_step(problem, 0.99));
    run->set_velocities([](const Vector<3>& x) {
      return Vector<3>{std::sin(40.0 * x[0]), std::cos(30.0 * x[1]), std::sin(20.0 * x[2] + x[0])};
    });
    std::vector<Averages<3>> averages;
    run->advance(1, averages);
    const auto total = [&] { return run->energy().kinetic + run->energy().strain; };
    const double before = total();
    run->advance(1000, averages);
    EXPECT_NEAR(total() / before, 1.0, 1e-10);
    EXPECT_GT(run->energy().strain, 0.01 * before);
  }
}

TEST(CubicBoxes, CarryPlaneWavesAtTheirSpeeds) {
  constexpr double side = 1.0 / 24;
  for (const bool is_shear : {false, true}) {
    DynamicProblem<3> problem{Discretisation<3>(Grid<3>{{2, 24, 2}, side}), {soft}};
    problem.boundary = Boundary::periodic;
    const auto run = make_dynamic_solver(Formulation::total_lagrangian, with_step(problem, 0.1));
    run->set_velocities([is_shear](const Vector<3>& x) {
      const double wave = std::sin(2.0 * std::numbers::pi * x[1]);
      return is_shear ? Vector<3>{0.0, 0.0, wave} : Vector<3>{0.0, wave, 0.0};
    });
    const double speed = is_shear ? shear_wave_speed(1e6, 1000.0) : dilatational_wave_speed(soft);
    std::vector<Averages<3>> averages;
    run->advance(1, averages);
    const double at_first = run->energy().kinetic;
    while (run->time() < 0.25 / speed) run->advance(1, averages);
    // A quarter of the period later the standing wave stands still.
    EXPECT_LT(run->energy().kinetic, 1e-3 * at_first);
    EXPECT_NEAR(run->energy().strain / at_first, 1.0, 1e-2);
  }
}

TEST(CubicBoxes, HoldEighteenNumbersPerCellAndShearTerm) {
  const auto footprint = [](const std::vector<MaxwellTerm>& terms) {
    const Material material{"material", 1e3, PronySeries(1e9), PronySeries(1e6, terms)};
    return make_dynamic_solver(Formulation::total_lagrangian,
                               with_step<3>({Discretisation<3>(Grid<3>{{16, 3, 2}, 0.1}), {material}}))
        ->footprint();
  };
  const auto without = footprint({}), with = footprint({{1.0, 1e6}, {2.0, 1e6}});
  const std::size_t history = 2 * 18 * sizeof(double) * 16 * 3 * 2;
  EXPECT_EQ(with.held - without.held, history);
  EXPECT_EQ(with.moved_per_step - without.moved_per_step, 2 * history);
}

TEST(CubicBoxes, RefuseTimeStepsAboveTheStableOne) {
  auto problem = with_step<3>({sphere_in_box(3), {soft, stiff}}, 1.01);
  EXPECT_THROW(make_dynamic_solver(Formulation::total_lagrangian, problem), InputError);
}

}  // namespace
}  // namespace breccia
