// Tests of bounds that hold for the moduli of every composite (docs/verification.md).

#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "properties/random_composite.hpp"

namespace breccia {
namespace {

using test::boundaries;
using test::FillerKind;
using test::random_composite;

/// The Carson modulus s M~(s) [Pa] of a relaxation modulus M(t) at a real Laplace variable [1/s]: an elastic modulus of
/// the composite whose materials have their Carson moduli at the same s.
double carson(const PronySeries& series, double s) {
  double modulus = series.equilibrium();
  for (const auto& [relaxation_time, stiffness] : series.terms()) {
    modulus += stiffness * s * relaxation_time / (1.0 + s * relaxation_time);
  }
  return modulus;
}

/// The modulus of a material under a load: G, or K + G / 3.
double modulus_under(Load load, const Material& material, double s) {
  const double shear = carson(material.shear, s);
  return load == Load::bulk ? carson(material.bulk, s) + shear / 3.0 : shear;
}

/// Arithmetic and harmonic means of the moduli over the points.
struct Means {
  double voigt = 0.0, reuss = 0.0;  ///< [Pa]
};

Means means(const QuasistaticTest& test, Load load, double s) {
  const auto fractions = std::get<Discretisation<2>>(test.composite).fractions(2);
  double stiffness = 0.0, compliance = 0.0;
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    const double modulus = modulus_under(load, test.materials[i], s);
    stiffness += fractions[i] * modulus;
    compliance += fractions[i] / modulus;
  }
  return {stiffness, 1.0 / compliance};
}

void expect_positive_and_falling(const Curve& curve, const char* what) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_GT(curve[i].modulus, 0.0) << what;
    if (i == 0) continue;
    EXPECT_LT(curve[i].modulus, curve[i - 1].modulus) << what << " at " << curve[i].time;
  }
}

TEST(RandomComposites, HaveModuliThatArePositiveAndFall) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const auto boundary : boundaries) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", boundary " << static_cast<int>(boundary));
      auto test = quasistatic_test(random_composite(seed), boundary);
      for (const auto& response : run_quasistatic_test(test).responses) {
        expect_positive_and_falling(response.modulus, "reduced");
      }
      if (seed > 4) continue;
      test = quasistatic_test(random_composite(seed, FillerKind::relaxing), boundary);
      test.options.solver = Solver::stepping;
      for (const auto& response : run_quasistatic_test(test).responses) {
        expect_positive_and_falling(response.modulus, "stepping");
      }
    }
  }
}

TEST(RandomComposites, LieBetweenReussAndVoigtInTheOrderOfTheirBoundaries) {
  constexpr double sampling = 1e-4;  // relative, beyond the tolerance of the reduced basis
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto composite = random_composite(seed);
    std::map<Boundary, QuasistaticTestResult> results;
    for (const auto boundary : boundaries) {
      results[boundary] = run_quasistatic_test(quasistatic_test(composite, boundary));
    }
    const auto test = quasistatic_test(composite, Boundary::periodic);
    for (std::size_t i = 0; i < test.loads.size(); ++i) {
      for (const double s : {1.0 / test::window.end, 100.0, 1.0 / test::window.begin}) {
        const auto modulus = [&](Boundary boundary) { return carson(results.at(boundary).responses[i].series, s); };
        const auto [voigt, reuss] = means(test, test.loads[i], s);
        const double traction = modulus(Boundary::traction), periodic = modulus(Boundary::periodic),
                     displacement = modulus(Boundary::displacement);
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", load " << i << ", s " << s);
        EXPECT_LE(reuss, traction * (1.0 + sampling));
        EXPECT_LE(traction, periodic * (1.0 + sampling));
        EXPECT_LE(periodic, displacement * (1.0 + sampling));
        EXPECT_LE(displacement, voigt * (1.0 + sampling));
      }
    }
  }
}

TEST(RandomComposites, MayExceedTheMeanModulusInTime) {
  // A soft elastic phase is in a stiff one that flows: stress moves to the elastic phase with time, so that the flowing
  // phase is loaded less than by its own relaxation.
  Microstructure<2> box = {1e-3, Walls::hard, {}};
  box.particles.push_back({{0.5e-3, 0.5e-3}, 0.9e-3});
  const test::Composite composite = {
      box,
      {{"matrix", 1000.0, PronySeries(0.0, {{0.01, 300e6}}), PronySeries(0.0, {{0.01, 100e6}})},
       {"filler", 1000.0, PronySeries(3e6), PronySeries(1e6)}}};
  const auto test = quasistatic_test(composite, Boundary::displacement);
  const auto series = run_quasistatic_test(test).responses[0].series;
  const auto fractions = std::get<Discretisation<2>>(test.composite).fractions(2);
  constexpr double late = 0.1;
  double mean = 0.0;
  for (std::size_t m = 0; m < fractions.size(); ++m) mean += fractions[m] * test.materials[m].shear.at(late);
  EXPECT_GT(series.at(late), mean);
}

TEST(RandomComposites, AgreeWithTheQuasiStaticMethod) {
  for (const std::uint64_t seed : {1U, 2U, 5U, 6U}) {
    const auto composite = random_composite(seed, FillerKind::relaxing);
    for (const auto boundary : {Boundary::displacement, Boundary::periodic}) {
      auto slow = quasistatic_test(composite, boundary);
      slow.options.solver = Solver::stepping;
      const auto expected = run_quasistatic_test(slow).responses[0].modulus;
      const auto curve = run_dynamic_test(dynamic_test(composite, boundary)).curve;
      ASSERT_EQ(curve.size(), expected.size());
      for (std::size_t i = 0; i < curve.size(); ++i) {
        EXPECT_NEAR(curve[i].modulus / expected[i].modulus, 1.0, 0.03) << "seed " << seed << " at " << curve[i].time;
      }
    }
  }
}

}  // namespace
}  // namespace breccia
