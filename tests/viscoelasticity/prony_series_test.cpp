#include "breccia/viscoelasticity/prony_series.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {
namespace {

const PronySeries two_terms(1e6, {{0.1, 2e6}, {10.0, 3e6}});

TEST(PronySeries, FollowsItsDefinition) {
  EXPECT_DOUBLE_EQ(two_terms.unrelaxed(), 6e6);
  EXPECT_DOUBLE_EQ(two_terms.at(1.0), 1e6 + 2e6 * std::exp(-10.0) + 3e6 * std::exp(-0.1));
  EXPECT_DOUBLE_EQ(two_terms.at(1e9), 1e6);
}

TEST(PronySeries, KeepsItsTermsInOrderOfFallingRelaxationTime) {
  EXPECT_EQ(two_terms.terms().front().relaxation_time, 10.0);
  EXPECT_EQ(two_terms, PronySeries(1e6, {{10.0, 3e6}, {0.1, 2e6}}));
}

TEST(PronySeries, WithoutTermsIsElastic) {
  EXPECT_TRUE(PronySeries(5.0).is_elastic());
  EXPECT_EQ(PronySeries(5.0).at(3.0), 5.0);
  EXPECT_FALSE(two_terms.is_elastic());
}

TEST(PronySeries, ComplexModulusOfAMaxwellElementPeaksAtItsRate) {
  const PronySeries maxwell(0.0, {{0.5, 8.0}});
  const auto modulus = maxwell.complex_modulus(2.0);
  EXPECT_DOUBLE_EQ(modulus.real(), 4.0);
  EXPECT_DOUBLE_EQ(modulus.imag(), 4.0);
}

TEST(PronySeries, ComplexModulusRunsFromRelaxedToUnrelaxed) {
  EXPECT_NEAR(std::abs(two_terms.complex_modulus(1e-9)), 1e6, 1.0);
  EXPECT_NEAR(std::abs(two_terms.complex_modulus(1e9)), 6e6, 1.0);
}

TEST(PronySeries, ShiftMovesTheCurveInLogTime) {
  const auto shifted = two_terms.shifted(100.0);
  for (const double t : {1e-3, 0.1, 2.0, 30.0}) EXPECT_DOUBLE_EQ(shifted.at(100.0 * t), two_terms.at(t));
}

TEST(PronySeries, RefusesInvalidModuliAndTimes) {
  EXPECT_THROW(PronySeries(-1.0), InputError);
  EXPECT_THROW(PronySeries(std::nan("")), InputError);
  EXPECT_THROW(PronySeries(0.0, {{0.0, 1.0}}), InputError);
  EXPECT_THROW(PronySeries(0.0, {{1.0, -1.0}}), InputError);
  EXPECT_THROW(PronySeries(0.0, {{std::numeric_limits<double>::infinity(), 1.0}}), InputError);
}

TEST(Material, WaveSpeeds) {
  const Material steel_like = {"s", 1000.0, PronySeries(3e9), PronySeries(0.75e9)};
  EXPECT_DOUBLE_EQ(dilatational_wave_speed(steel_like), 2000.0);
  EXPECT_DOUBLE_EQ(shear_wave_speed(4e6, 1000.0), std::sqrt(4000.0));
}

}  // namespace
}  // namespace breccia
