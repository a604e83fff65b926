// Tests of the dynamic method in three dimensions against exact solutions and the quasi-static method.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/virtual_test/modulus_bounds.hpp"

#include "discretisation/mixed_cells.hpp"
#include "discretisation/mixture_rule.hpp"
#include "messages.hpp"
#include "virtual_test/dynamic_test.hpp"
#include "virtual_test/quasistatic_test.hpp"

namespace breccia {
namespace {

/// A rubber that relaxes tenfold, and a stiff filler.
const Material rubber = {"rubber", 1100.0, PronySeries(2e9), PronySeries(10e6, {{1e-3, 90e6}})};
const Material glass = {"glass", 2500.0, PronySeries(40e9), PronySeries(30e9)};

DynamicTest<3> homogeneous_cube(const Material& material, TimeWindow times) {
  return {.discretisation = Discretisation<3>(Grid<3>{{6, 6, 6}, 1e-3 / 6}), .materials = {material}, .times = times};
}

TEST(DynamicTestInSpace, AHomogeneousCubeRelaxesAsItsMaterial) {
  const Material material = {"m", 1000.0, PronySeries(20e6, {{2e-2, 30e6}}), PronySeries(1e6, {{1e-2, 5e6}})};
  for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
    for (const auto load : {Load::shear_yz, Load::diagonal_shear_yz, Load::bulk}) {
      auto test = homogeneous_cube(material, {2e-3, 0.05});
      test.boundary = boundary;
      test.load = load;
      const auto& exact = load == Load::bulk ? material.bulk : material.shear;
      const auto curve = run_dynamic_test(test).curve;
      ASSERT_FALSE(curve.empty());
      for (const auto& [time, modulus] : curve) EXPECT_NEAR(modulus / exact.at(time), 1.0, 1e-3) << "at " << time;
    }
  }
}

TEST(DynamicTestInSpace, AHomogeneousCubeCreepsAsItsMaterial) {
  auto test = homogeneous_cube({"m", 1000.0, PronySeries(1e6), PronySeries(0.0, {{0.01, 0.5e6}})}, {2e-3, 0.02});
  test.boundary = Boundary::traction;
  for (const auto& [time, compliance] : run_dynamic_test(test).compliance) {
    EXPECT_NEAR(compliance * 0.5e6 / (1.0 + time / 0.01), 1.0, 3e-3) << "at " << time;
  }
}

/// Under a unit load the uniform stress is the modulus, the strain is the load, and the displacement of a point is the
/// strain times its distance from the centre, apart from the remaining waves of the ramp.
TEST(DynamicTestInSpace, FieldsOfAHomogeneousCubeAreUniform) {
  const Material material = {"m", 1000.0, PronySeries(20e6, {{2e-2, 30e6}}), PronySeries(1e6, {{1e-2, 5e6}})};
  auto test = homogeneous_cube(material, {2e-3, 0.05});
  test.load = Load::shear_zx;
  test.field_times = {5e-3, 0.05};
  const auto result = run_dynamic_test(test);
  const auto& fields_of_cells = std::get<GridFields<3>>(result.fields).at_times;
  ASSERT_EQ(fields_of_cells.size(), 2U);
  constexpr double rings = 3e-3;  // strain; the stress of pressure waves is their stiffness times as much
  const double stiffness_of_waves = material.bulk.unrelaxed() + 4.0 / 3.0 * material.shear.unrelaxed();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [time, fields] = fields_of_cells[i];
    EXPECT_NEAR(time / test.field_times[i], 1.0, 0.02);
    ASSERT_EQ(fields.stress.size(), 216U) << "by cell, not by point";
    ASSERT_EQ(fields.phase.size(), 216U);
    const double modulus = material.shear.at(time);
    for (std::size_t cell = 0; cell < 216; ++cell) {
      for (std::size_t component = 0; component < 6; ++component) {
        const bool is_loaded = component == 4;  // zx
        EXPECT_NEAR(fields.strain[cell][component], is_loaded ? 0.5 : 0.0, rings);
        if (is_loaded) {
          EXPECT_NEAR(fields.stress[cell][component] / modulus, 1.0, 5 * rings);
        } else {
          EXPECT_NEAR(fields.stress[cell][component], 0.0, rings * stiffness_of_waves);
        }
      }
      const std::size_t column = cell % 6, plane = cell / 36;
      const double x = (static_cast<double>(column) - 2.5) / 6e3, z = (static_cast<double>(plane) - 2.5) / 6e3;
      EXPECT_NEAR(fields.displacement[cell][0], 0.5 * z, rings * 1e-3);
      EXPECT_NEAR(fields.displacement[cell][1], 0.0, rings * 1e-3);
      EXPECT_NEAR(fields.displacement[cell][2], 0.5 * x, rings * 1e-3);
    }
  }
}

/// Stress is the same in all layers of a laminate in shear along them, so their compliances add up.
TEST(DynamicTestInSpace, AMaxwellLaminateHasTheSeriesModulus) {
  auto test = homogeneous_cube({"m", 1000.0, PronySeries(1e6), PronySeries(0.2e6, {{1e-2, 0.5e6}})}, {1e-3, 0.02});
  test.materials.push_back({"stiff", 1500.0, PronySeries(5e6), PronySeries(3e6)});
  test.discretisation.paint([](const Vector<3>& x) { return x[2] > 0.5e-3; }, 1);
  test.boundary = Boundary::periodic;
  test.load = Load::shear_yz;
  // A laminate is softer along its layers than the program expects from the bounds of isotropic composites.
  test.options.mass_scaling_factors = {20.0, 200.0};
  // The period of its slowest wave is about two transits, so that a ramp of four transits excites little ringing.
  test.options.ramp_transits = 4.0;
  const auto series = MixtureRule({{0, 0.5}, {1, 0.5}}).material<3>(test.materials).shear;
  for (const auto& [time, modulus] : run_dynamic_test(test).curve) {
    EXPECT_NEAR(modulus / series.at(time), 1.0, 5e-3) << "at " << time;
  }
}

/// Relative difference of fields from others in the Euclidean norm of all cells [-].
template <std::size_t components>
double distance(const std::vector<std::array<double, components>>& found,
                const std::vector<std::array<double, components>>& expected) {
  double squared = 0.0, whole = 0.0;
  for (std::size_t cell = 0; cell < expected.size(); ++cell) {
    for (std::size_t i = 0; i < components; ++i) {
      squared += std::pow(found[cell][i] - expected[cell][i], 2);
      whole += std::pow(expected[cell][i], 2);
    }
  }
  return std::sqrt(squared / whole);
}

/// Displacements minus their mean.
std::vector<Vector<3>> from_mean(std::vector<Vector<3>> displacements) {
  Vector<3> mean{};
  for (const auto& u : displacements) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += u[i] / static_cast<double>(displacements.size());
  }
  for (auto& u : displacements) {
    for (std::size_t i = 0; i < 3; ++i) u[i] -= mean[i];
  }
  return displacements;
}

class SphereInACube : public testing::TestWithParam<Boundary> {};

TEST_P(SphereInACube, HasTheSameModuliAndFieldsByBothMethods) {
  constexpr std::array<PhaseIndex, 1> sphere = {1};
  const auto box =
      discretise_mixed<3>({1e-3, Walls::hard, {Ball<3>{{0.5e-3, 0.5e-3, 0.5e-3}, 0.8e-3}}}, 8, 0, sphere, 2);
  const std::vector<Material> materials = {rubber, glass};
  DynamicTest<3> moving = {.discretisation = box,
                           .materials = with_mixtures(box, materials),
                           .boundary = GetParam(),
                           .times = {1e-4, 1e-2},
                           .points_per_decade = 5,
                           .field_times = {1e-2}};  // the rubber has relaxed, and waves have died away
  const QuasistaticTest still = {.composite = box,
                                 .materials = materials,
                                 .varying = {{0, "matrix"}},
                                 .boundary = GetParam(),
                                 .loads = {Load::shear},
                                 .times = moving.times,
                                 .points_per_decade = 5,
                                 .field_times = moving.field_times};
  const auto found = run_dynamic_test(moving);
  const auto quasistatic = run_quasistatic_test(still);
  const auto& expected = quasistatic.responses.front();
  ASSERT_EQ(times_of(found.fields).size(), 1U);
  const auto& moved = std::get<GridFields<3>>(found.fields).at_times.front().fields;
  const auto& rests = std::get<GridFields<3>>(quasistatic.fields).at_times.front().fields;
  EXPECT_EQ(moved.phase, rests.phase);
  EXPECT_LT(distance(moved.stress, rests.stress), 0.01);
  EXPECT_LT(distance(moved.strain, rests.strain), 0.01);
  // The point of the box that is at rest is arbitrary, and so is the rotation of the box under tractions.
  if (GetParam() != Boundary::traction) {
    EXPECT_LT(distance(from_mean(moved.displacement), from_mean(rests.displacement)), 0.01);
  }
  if (GetParam() == Boundary::traction) {
    ASSERT_EQ(found.compliance.size(), expected.compliance.size());
    for (std::size_t i = 0; i < found.compliance.size(); ++i) {
      EXPECT_NEAR(found.compliance[i].compliance / expected.compliance[i].compliance, 1.0, 0.01);
    }
    return;
  }
  ASSERT_EQ(found.curve.size(), expected.modulus.size());
  for (std::size_t i = 0; i < found.curve.size(); ++i) {
    EXPECT_NEAR(found.curve[i].modulus / expected.modulus[i].modulus, 1.0, 0.01) << "at " << found.curve[i].time;
  }
}

/// The test compares curves, which are smoothed over the ringing of waves; single samples of two runs that ring differ
/// more (CubesUnderEveryBoundary).
TEST_P(SphereInACube, HasTheSameCurveByBothFormulations) {
  DynamicTest<3> test = {
      .discretisation = discretise<3>({1e-3, Walls::hard, {Ball<3>{{0.5e-3, 0.5e-3, 0.5e-3}, 0.8e-3}}}, 6, 0, 1),
      .materials = {rubber, glass},
      .boundary = GetParam(),
      .times = {1e-5, 5e-5}};
  const auto lagrangian = run_dynamic_test(test);
  test.options.formulation = Formulation::classical;
  const auto classical = run_dynamic_test(test);
  ASSERT_FALSE(lagrangian.curve.empty());
  ASSERT_EQ(classical.curve.size(), lagrangian.curve.size());
  for (std::size_t i = 0; i < lagrangian.curve.size(); ++i) {
    EXPECT_NEAR(classical.curve[i].modulus / lagrangian.curve[i].modulus, 1.0, 0.005)
        << "at " << lagrangian.curve[i].time;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SphereInACube,
                         testing::Values(Boundary::displacement, Boundary::traction, Boundary::periodic),
                         [](const auto& chosen) { return std::string(name_of(chosen.param)); });

TEST(DynamicTestInSpace, OfAFinerGridIsPlannedByACoarseOne) {
  auto coarse = homogeneous_cube(rubber, {1e-4, 1e-2}), fine = coarse;
  fine.discretisation = Discretisation<3>(Grid<3>{{12, 12, 12}, 1e-3 / 12});
  const auto planned = plan_dynamic_test(coarse, 2.0), expected = plan_dynamic_test(fine);
  EXPECT_EQ(dynamic_memory(coarse, 2.0), dynamic_memory(fine));
  ASSERT_EQ(planned.size(), expected.size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(planned[i].steps) / static_cast<double>(expected[i].steps), 1.0, 1e-3);
  }
}

TEST(DynamicTestInSpace, BoundsAreThoseOfHashinAndShtrikman) {
  DynamicTest<3> test = homogeneous_cube(rubber, {1e-4, 1e-2});
  test.materials.push_back(glass);
  test.discretisation.paint([](const Vector<3>& x) { return x[0] < 0.5e-3; }, 1);
  const ShearModulusBounds bounds(test.discretisation, test.materials);
  // The lower bound of Hashin and Shtrikman for half of each phase, with the soft phase around: G + c / (1 / dG + 6 c
  // (K + 2 G) / (5 G (3 K + 4 G))).
  const double g = rubber.shear.at(1e-3), k = 2e9;
  const double lower = g + 0.5 / (1.0 / (30e9 - g) + 6.0 * 0.5 * (k + 2.0 * g) / (5.0 * g * (3.0 * k + 4.0 * g)));
  EXPECT_NEAR(bounds.lower(1e-3) / lower, 1.0, 1e-12);
  EXPECT_GT(bounds.upper(1e-3), 50.0 * lower);
}

TEST(DynamicTestInSpace, LoadsOfSpaceAreRefusedInThePlane) {
  DynamicTest<2> test = {.discretisation = Discretisation<2>(Grid<2>{{4, 4}, 1e-3}),
                         .materials = {rubber},
                         .load = Load::shear_yz,
                         .times = {1e-4, 1e-2}};
  EXPECT_THAT(test::message_of<InputError>([&] { (void)run_dynamic_test(test); }), testing::HasSubstr("shear-yz"));
}

}  // namespace
}  // namespace breccia
