#include "viscoelasticity/engineering_moduli.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "binder.hpp"

namespace breccia {
namespace {

TEST(EngineeringModuli, OfAnElasticSolid) {
  const EngineeringModuli solid(PronySeries(3e9), PronySeries(5e9));
  const double young = 9.0 * 3.0 * 5.0 / 18.0 * 1e9, poisson = 9.0 / 36.0;
  for (const double t : {1e-9, 1.0, 1e9}) {
    EXPECT_NEAR(solid.youngs_modulus(t) / young, 1.0, 1e-11);
    EXPECT_NEAR(solid.poisson_ratio(t), poisson, 1e-11);
  }
  EXPECT_NEAR(solid.complex_youngs_modulus(1.0).real() / young, 1.0, 1e-14);
  EXPECT_NEAR(solid.complex_youngs_modulus(1.0).imag(), 0.0, 1e-3);
}

/// With a constant Poisson's ratio all moduli have the same shape.
TEST(EngineeringModuli, OfASolidOfConstantPoissonsRatio) {
  const double poisson = 0.3;
  const EngineeringModuli solid(binder, binder.scaled(2.0 * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson))));
  for (double t = 1e-12; t < 1e7; t *= 7.0) {
    EXPECT_NEAR(solid.youngs_modulus(t) / (2.0 * (1.0 + poisson) * binder.at(t)), 1.0, 1e-9) << t;
    EXPECT_NEAR(solid.poisson_ratio(t), poisson, 1e-9);
    EXPECT_NEAR(
        std::abs(solid.complex_youngs_modulus(1.0 / t) / (2.0 * (1.0 + poisson) * binder.complex_modulus(1.0 / t))),
        1.0, 1e-12);
  }
}

/// The uniaxial creep compliance is J / 3 + B / 9; its relaxation modulus follows exactly by interconversion.
TEST(EngineeringModuli, OfARelaxingSolidFollowFromItsCompliances) {
  const PronySeries bulk(2.5e9, {{1e-6, 4e8}, {1e-2, 7e8}, {10.0, 2e8}});
  const auto of_shear = creep_compliance(binder), of_bulk = creep_compliance(bulk);
  std::vector<RetardationTerm> terms;
  for (const auto& [time, compliance] : of_shear.terms()) terms.push_back({time, compliance / 3.0});
  for (const auto& [time, compliance] : of_bulk.terms()) terms.push_back({time, compliance / 9.0});
  const CreepCompliance tensile(of_shear.instantaneous() / 3.0 + of_bulk.instantaneous() / 9.0, terms,
                                of_shear.fluidity() / 3.0 + of_bulk.fluidity() / 9.0);
  const auto young = relaxation_modulus(tensile);
  const EngineeringModuli solid(binder, bulk);
  for (double t = 1e-13; t < 1e8; t *= 3.0) {
    EXPECT_NEAR(solid.youngs_modulus(t) / young.at(t), 1.0, 1e-9) << t;
    EXPECT_NEAR(solid.tensile_compliance(t) / tensile.at(t), 1.0, 1e-9) << t;
  }
}

/// A standard solid in shear with an elastic bulk modulus: nu(t) = nu_inf - (nu_inf - nu_0) exp(-t / lambda), where
/// 1 / lambda is the root of 3 K + G(s).
TEST(EngineeringModuli, PoissonsRatioOfAStandardSolid) {
  const double bulk = 3e9, equilibrium = 1e8, strength = 9e8, time = 2.0;
  const EngineeringModuli solid(PronySeries(equilibrium, {{time, strength}}), PronySeries(bulk));
  const auto ratio = [&](double shear) { return (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear); };
  const double lambda = time * (3.0 * bulk + equilibrium + strength) / (3.0 * bulk + equilibrium);
  for (const double t : {0.01, 1.0, 2.0, 10.0, 50.0}) {
    const double first = ratio(equilibrium + strength), last = ratio(equilibrium);
    EXPECT_NEAR(solid.poisson_ratio(t), last - (last - first) * std::exp(-t / lambda), 1e-10);
  }
  EXPECT_LT(solid.complex_poisson_ratio(1.0 / time).imag(), 0.0);
}

}  // namespace
}  // namespace breccia
