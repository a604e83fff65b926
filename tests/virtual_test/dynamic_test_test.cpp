#include "virtual_test/dynamic_test.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/virtual_test/modulus_bounds.hpp"

#include "virtual_test/composites.hpp"

namespace breccia {
namespace {

using testing_composites::binder;
using testing_composites::model_composite;
using testing_composites::particle;

DynamicTest<2> relaxation(Discretisation<2> discretisation, std::vector<Material> materials, TimeWindow times) {
  return {.discretisation = std::move(discretisation), .materials = std::move(materials), .times = times};
}

double at(const Curve& curve, double time) {
  return smoothed_at(curve, time);
}

TEST(RunDynamicTest, HomogeneousBoxRelaxesAsItsMaterial) {
  // Late times, at which the material has relaxed faster than waves cross the box, take falling mass scaling factors.
  for (const auto start : {Start::boundary, Start::affine}) {
    auto test = relaxation(model_composite(24), {binder, binder}, {1e-3, 0.12});
    test.options.start = start;
    const auto result = run_dynamic_test(test);
    for (const auto& [time, modulus] : result.curve) {
      EXPECT_NEAR(modulus / (0.5e6 * std::exp(-time / 0.01)), 1.0, 1e-3) << "at " << time;
    }
  }
}

TEST(RunDynamicTest, BulkLoadGivesThePlaneStrainBulkModulus) {
  const Material relaxing_bulk = {"m", 1000.0, PronySeries(1e6, {{0.02, 3e6}}), PronySeries(0.1e6, {{0.01, 0.5e6}})};
  auto test = relaxation(Discretisation<2>(Grid<2>{{24, 24}, 6e-3 / 24}), {relaxing_bulk}, {1e-3, 0.05});
  test.load = Load::bulk;
  for (const auto& [time, modulus] : run_dynamic_test(test).curve) {
    EXPECT_NEAR(modulus / (relaxing_bulk.bulk.at(time) + relaxing_bulk.shear.at(time) / 3.0), 1.0, 1e-3);
  }
}

TEST(RunDynamicTest, HomogeneousPeriodicBoxRelaxesAsItsMaterial) {
  auto test = relaxation(model_composite(24), {binder, binder}, {1e-3, 0.05});
  test.boundary = Boundary::periodic;
  for (const auto& [time, modulus] : run_dynamic_test(test).curve) {
    EXPECT_NEAR(modulus / (0.5e6 * std::exp(-time / 0.01)), 1.0, 1e-3) << "at " << time;
  }
}

DynamicTest<2> creep(Discretisation<2> discretisation, std::vector<Material> materials, TimeWindow times) {
  auto test = relaxation(std::move(discretisation), std::move(materials), times);
  test.boundary = Boundary::traction;
  return test;
}

TEST(RunDynamicTest, HomogeneousBoxCreepsAsItsMaterial) {
  // A Maxwell element flows: J = (1 + t / tau) / G.
  const auto result = run_dynamic_test(creep(model_composite(24), {binder, binder}, {1e-3, 0.05}));
  for (const auto& [time, compliance] : result.compliance) {
    EXPECT_NEAR(compliance * 0.5e6 / (1.0 + time / 0.01), 1.0, 3e-3) << "at " << time;
  }
  for (const auto& [time, modulus] : result.curve) {
    if (time > 0.02) break;  // later J depends little on G
    EXPECT_NEAR(modulus / (0.5e6 * std::exp(-time / 0.01)), 1.0, 0.03) << "at " << time;
  }
}

TEST(RunDynamicTest, AnElasticBoxUnderTractionHardlyRings) {
  // There is no damping: the free boundary rings with the frequencies that the ramp excites.
  const Material elastic = {"elastic", 1000.0, PronySeries(1e6), PronySeries(0.5e6)};
  for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
    auto test = creep(model_composite(24), {elastic, elastic}, {1e-3, 0.02});
    test.load = load;
    const double expected = load == Load::bulk ? 1e6 + 0.5e6 / 3.0 : 0.5e6;
    for (const auto& [time, compliance] : run_dynamic_test(test).compliance) {
      EXPECT_NEAR(compliance * expected, 1.0, 0.01) << "at " << time;
    }
  }
}

/// Quasi-static values of the model composite from an independent computation with standard points, 48 cells a side.
struct Known {
  double time;
  double modulus;
};
constexpr std::array<Known, 5> known_standard_48 = {
    {{1e-3, 0.841164e6}, {3e-3, 0.705966e6}, {1e-2, 0.392194e6}, {3e-2, 0.102588e6}, {5e-2, 0.0491607e6}}};

class ModelComposite : public testing::TestWithParam<Start> {};

TEST_P(ModelComposite, AgreesWithTheQuasiStaticLimit) {
  auto test = relaxation(model_composite(48), {binder, particle}, {1e-3, 0.05});
  test.volumetric = Volumetric::standard;
  test.options.start = GetParam();
  const auto result = run_dynamic_test(test);
  for (const auto& [time, modulus] : known_standard_48) {
    EXPECT_NEAR(at(result.curve, time) / modulus, 1.0, 0.01) << "at " << time;
  }
  EXPECT_GE(result.domains.size(), 2U);
  for (const auto& overlap : result.overlaps) EXPECT_LT(overlap.mismatch, 0.03);
}

INSTANTIATE_TEST_SUITE_P(BothStarts, ModelComposite, testing::Values(Start::boundary, Start::affine),
                         [](const auto& chosen) {
                           return std::string(chosen.param == Start::affine ? "Affine" : "Boundary");
                         });

TEST(RunDynamicTest, AveragedPointsAgreeWithTheQuasiStaticLimit) {
  const auto result = run_dynamic_test(relaxation(model_composite(48), {binder, particle}, {1e-3, 0.05}));
  constexpr std::array<Known, 3> known = {{{1e-3, 0.841293e6}, {1e-2, 0.390748e6}, {5e-2, 0.0457392e6}}};
  for (const auto& [time, modulus] : known) EXPECT_NEAR(at(result.curve, time) / modulus, 1.0, 0.01) << "at " << time;
}

TEST(RunDynamicTest, GivenMassScalingFactorsAreUsed) {
  auto test = relaxation(model_composite(24), {binder, particle}, {2e-3, 0.02});
  test.options.mass_scaling_factors = {1.0, 5.0};
  const auto result = run_dynamic_test(test);
  ASSERT_EQ(result.domains.size(), 2U);
  EXPECT_EQ(result.domains[0].mass_scaling, 1.0);
  EXPECT_EQ(result.domains[1].mass_scaling, 5.0);
}

TEST(RunDynamicTest, MassScalingFactorsThatStartTooLateAreRefused) {
  auto test = relaxation(model_composite(24), {binder, particle}, {1e-4, 0.02});
  test.options.mass_scaling_factors = {1.0};
  EXPECT_THROW(run_dynamic_test(test), NumericalError);
}

TEST(RunDynamicTest, ALongRampDelaysTheWindow) {
  auto test = relaxation(model_composite(24), {binder, particle}, {1e-3, 0.05});
  test.options.ramp_transits = 20.0;
  EXPECT_THROW(run_dynamic_test(test), NumericalError);
}

TEST(RunDynamicTest, TimesThatWouldTakeForeverAreRefused) {
  EXPECT_THROW(run_dynamic_test(relaxation(model_composite(24), {binder, particle}, {1.0, 2.0})), NumericalError);
}

TEST(RunDynamicTest, ProgressMayInterrupt) {
  const auto test = relaxation(model_composite(24), {binder, particle}, {1e-3, 0.05});
  int calls = 0;
  const auto stop = [&](const Progress& progress) {
    EXPECT_GE(progress.share, 0.0);
    if (++calls == 10) throw Interrupted("stop");
  };
  EXPECT_THROW(run_dynamic_test(test, stop), Interrupted);
}

TEST(RunDynamicTest, FieldsAverageToTheModulus) {
  auto test = relaxation(model_composite(24), {binder, particle}, {1e-3, 50e-3});
  test.field_times = {1e-3, 7e-3, 50e-3};
  const auto result = run_dynamic_test(test);
  EXPECT_GT(result.domains.size(), 1U);
  const auto& fields_of_points = std::get<GridFields<2>>(result.fields).at_times;
  ASSERT_EQ(fields_of_points.size(), test.field_times.size());
  for (std::size_t i = 0; i < fields_of_points.size(); ++i) {
    const auto& [time, fields] = fields_of_points[i];
    EXPECT_NEAR(time / test.field_times[i], 1.0, 0.01);
    double stress = 0.0, strain = 0.0;
    for (std::size_t p = 0; p < fields.stress.size(); ++p) {
      stress += fields.stress[p][3] / static_cast<double>(fields.stress.size());
      strain += 2.0 * fields.strain[p][2] / static_cast<double>(fields.stress.size());
    }
    EXPECT_NEAR(strain, 1.0, 1e-12);
    // The field is of a time up to a sample later, in which a modulus falls by less than 2 %.
    const double modulus = smoothed_at(result.curve, test.field_times[i]);
    EXPECT_NEAR(stress / modulus, 1.0, 0.02) << time;
  }
}

TEST(RunDynamicTest, RefusesInvalidTests) {
  auto test = relaxation(model_composite(12), {binder, particle}, {1e-2, 1e-3});
  EXPECT_THROW(run_dynamic_test(test), InputError);
  test.times = {1e-3, 1e-2};
  test.field_times = {2e-2};
  EXPECT_THROW(run_dynamic_test(test), InputError) << "fields after the last time";
  test.field_times = {};
  test.options.courant = 1.5;
  EXPECT_THROW(run_dynamic_test(test), InputError);
  test.options.courant = 0.5;
  for (const int per_decade : {0, -1}) {
    test.points_per_decade = per_decade;
    EXPECT_THROW(run_dynamic_test(test), InputError) << per_decade << " points per decade";
  }
  test.points_per_decade = 20;
  test.materials.pop_back();
  EXPECT_THROW(run_dynamic_test(test), InputError) << "the particles have no material";
  EXPECT_THROW(static_cast<void>(plan_dynamic_test(test)), InputError);
  EXPECT_THROW(static_cast<void>(mean_density(test.discretisation, test.materials)), InputError);
}

// The number of steps grows with the number of cells along an axis; the time domains are the same.
TEST(PlanDynamicTest, OfAFinerGridIsMadeByACoarseOne) {
  const auto coarse = relaxation(model_composite(12), {binder, binder}, {1e-3, 0.02});
  const auto fine = relaxation(model_composite(36), {binder, binder}, {1e-3, 0.02});
  const auto planned = plan_dynamic_test(coarse, 3.0), expected = plan_dynamic_test(fine);
  EXPECT_EQ(dynamic_memory(coarse, 3.0), dynamic_memory(fine));
  ASSERT_EQ(planned.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(planned[i].time_step / expected[i].time_step, 1.0, 1e-9);
    EXPECT_NEAR(static_cast<double>(planned[i].steps), static_cast<double>(expected[i].steps), 1.0);
  }
}

TEST(PlanDynamicTest, HomogeneousPlanAgreesWithTheRun) {
  const auto test = relaxation(model_composite(24), {binder, binder}, {1e-3, 0.02});
  const auto plan = plan_dynamic_test(test);
  const auto result = run_dynamic_test(test);
  ASSERT_EQ(plan.size(), result.domains.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    EXPECT_DOUBLE_EQ(plan[i].mass_scaling, result.domains[i].mass_scaling);
    EXPECT_NEAR(static_cast<double>(plan[i].steps) / static_cast<double>(result.domains[i].steps), 1.0, 0.05);
  }
}

// Each term of the histories of a cell has five numbers; a run may have both terms, or the slow one alone.
TEST(DynamicMemory, IsThatOfTheMostTermsOfAnyDomain) {
  const auto memory_with = [](const std::vector<MaxwellTerm>& terms) {
    const Material relaxing = {"binder", 1e3, PronySeries(1e6), PronySeries(1e4, terms)};
    return dynamic_memory(relaxation(model_composite(20), {relaxing, relaxing}, {1e-3, 1.0}));
  };
  const double one = memory_with({{1e-2, 1e5}}), two = memory_with({{1e-2, 1e5}, {0.1, 1e5}});
  EXPECT_NEAR(two - one, 400.0 * 5.0 * sizeof(double), 1e-6);
  EXPECT_EQ(memory_with({{1e-2, 1e5}, {1e9, 1e5}}), one) << "a term that does not relax in these times";
}

TEST(ShearModulusBounds, AreThoseOfHashinForTheModelComposite) {
  const auto box = model_composite(200);
  const double f = box.fractions(2)[1];
  // Hashin (1965): G = G1 + f2 / (1 / (G2 - G1) + f1 (k1 + 2 G1) / (2 G1 (k1 + G1))), phase 1 around phase 2.
  const auto hashin = [](double g1, double k1, double g2, double f2) {
    return g1 + f2 / (1.0 / (g2 - g1) + (1.0 - f2) * (k1 + 2.0 * g1) / (2.0 * g1 * (k1 + g1)));
  };
  const double gm = 0.5e6, gf = 18.8e6;
  const ShearModulusBounds bounds(box, {binder, particle});
  EXPECT_NEAR(bounds.lower(0.0) / hashin(gm, 1e6 + gm / 3.0, gf, f), 1.0, 1e-9);
  EXPECT_NEAR(bounds.upper(0.0) / hashin(gf, 50e6 + gf / 3.0, gm, 1.0 - f), 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(bounds.estimate(0.01), std::sqrt(bounds.lower(0.01) * bounds.upper(0.01)));
}

TEST(MeanDensity, CountsPoints) {
  const auto box = model_composite(120);
  EXPECT_NEAR(mean_density(box, {binder, particle}), 1000.0 + 500.0 * std::numbers::pi / 9.0, 3.0);
}

}  // namespace
}  // namespace breccia
