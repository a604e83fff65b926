// Tests of changes of a composite under which its modulus is invariant, or scales with the units.

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "properties/random_composite.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

using test::Composite;
using test::random_composite;

Composite with_lengths(Composite composite, double factor) {
  composite.box.side *= factor;
  for (auto& disc : composite.box.particles) {
    disc.diameter *= factor;
    for (double& x : disc.centre) x *= factor;
  }
  return composite;
}

Composite with_moduli(Composite composite, double factor) {
  for (auto& material : composite.materials) {
    material.bulk = material.bulk.scaled(factor);
    material.shear = material.shear.scaled(factor);
  }
  return composite;
}

Composite with_times(Composite composite, double factor) {
  for (auto& material : composite.materials) {
    material.bulk = material.bulk.shifted(factor);
    material.shear = material.shear.shifted(factor);
  }
  return composite;
}

Composite with_densities(Composite composite, double factor) {
  for (auto& material : composite.materials) material.density *= factor;
  return composite;
}

/// The composite with the centres of its discs elsewhere.
Composite moved(Composite composite, const std::function<Vector<2>(const Vector<2>&)>& move) {
  for (auto& disc : composite.box.particles) disc.centre = move(disc.centre);
  return composite;
}

Composite turned(const Composite& composite) {
  const double side = composite.box.side;
  return moved(composite, [side](const Vector<2>& at) { return Vector<2>{side - at[1], at[0]}; });
}

Composite mirrored(const Composite& composite) {
  const double side = composite.box.side;
  return moved(composite, [side](const Vector<2>& at) { return Vector<2>{side - at[0], at[1]}; });
}

Composite in_another_order(Composite composite) {
  auto& discs = composite.box.particles;
  std::ranges::reverse(discs);
  std::rotate(discs.begin(), discs.begin() + 1, discs.end());
  return composite;
}

std::vector<PronySeries> series_of(const QuasistaticTest& test) {
  std::vector<PronySeries> all;
  for (const auto& response : run_quasistatic_test(test).responses) all.push_back(response.series);
  return all;
}

std::vector<PronySeries> series_of(const Composite& composite, Boundary boundary) {
  return series_of(quasistatic_test(composite, boundary));
}

/// Largest relative difference of factor * one(t) and other(stretch * t).
double difference(const std::vector<PronySeries>& one, const std::vector<PronySeries>& other, double factor = 1.0,
                  double stretch = 1.0) {
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (const double time : logarithmic_times(test::window, 4)) {
      largest = std::max(largest, std::abs(other[i].at(stretch * time) / (factor * one[i].at(time)) - 1.0));
    }
  }
  return largest;
}

double difference(const Curve& one, const Curve& other, double factor = 1.0) {
  double largest = one.size() == other.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    largest = std::max(largest, std::abs(other[i].modulus / (factor * one[i].modulus) - 1.0));
  }
  return largest;
}

/// Relative tolerance for linear systems solved to 1e-10 and a composite with a contrast of up to a thousand.
constexpr double rounding = 1e-7;

class QuasistaticInvariance : public testing::TestWithParam<std::uint64_t> {
 protected:
  [[nodiscard]] static Composite composite() { return random_composite(GetParam()); }
};

TEST_P(QuasistaticInvariance, OfLengthsIsExact) {
  for (const auto boundary : test::boundaries) {
    EXPECT_EQ(series_of(with_lengths(composite(), 1024.0), boundary), series_of(composite(), boundary));
    EXPECT_EQ(difference(series_of(composite(), boundary), series_of(with_lengths(composite(), 1e-3), boundary)), 0.0);
  }
}

TEST_P(QuasistaticInvariance, OfModuliAndTimes) {
  for (const auto boundary : test::boundaries) {
    const auto before = series_of(composite(), boundary);
    EXPECT_LT(difference(before, series_of(with_moduli(composite(), 1e3), boundary), 1e3), rounding);
    auto later = quasistatic_test(with_times(composite(), 1e3), boundary);
    later.times = {1e3 * test::window.begin, 1e3 * test::window.end};
    EXPECT_LT(difference(before, series_of(later), 1.0, 1e3), rounding);
  }
}

TEST_P(QuasistaticInvariance, OfTurnsAndReflections) {
  for (const auto boundary : test::boundaries) {
    const auto before = series_of(composite(), boundary);
    EXPECT_LT(difference(before, series_of(turned(composite()), boundary)), rounding);
    EXPECT_LT(difference(before, series_of(mirrored(composite()), boundary)), rounding);
  }
}

TEST_P(QuasistaticInvariance, OfTheOrderOfParticlesIsExact) {
  for (const auto boundary : test::boundaries) {
    EXPECT_EQ(series_of(in_another_order(composite()), boundary), series_of(composite(), boundary));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, QuasistaticInvariance, testing::Values(1, 2, 3, 4), test::by_value);

class DynamicInvariance : public testing::TestWithParam<Boundary> {
 protected:
  [[nodiscard]] static Curve curve_of(const Composite& composite, double stretch = 1.0) {
    auto test = dynamic_test(composite, GetParam());
    test.times = {stretch * test::window.begin, stretch * test::window.end};
    return run_dynamic_test(test).curve;
  }
  const Composite composite = random_composite(2);
};

TEST_P(DynamicInvariance, OfScalesThatKeepTheSpeedOfWaves) {
  // With twice the size and a quarter of the density a wave takes the same time through the box.
  EXPECT_EQ(curve_of(with_densities(with_lengths(composite, 2.0), 0.25)), curve_of(composite));
  EXPECT_LT(difference(curve_of(composite), curve_of(with_densities(with_moduli(composite, 1e3), 1e3)), 1e3), rounding);
  EXPECT_LT(difference(curve_of(composite), curve_of(with_densities(with_times(composite, 10.0), 100.0), 10.0)),
            rounding);
}

TEST_P(DynamicInvariance, OfTurnsAndReflections) {
  EXPECT_LT(difference(curve_of(composite), curve_of(turned(composite))), rounding);
  EXPECT_LT(difference(curve_of(composite), curve_of(mirrored(composite))), rounding);
}

TEST_P(DynamicInvariance, OfTheOrderOfParticlesIsExact) {
  EXPECT_EQ(curve_of(in_another_order(composite)), curve_of(composite));
}

INSTANTIATE_TEST_SUITE_P(Boundaries, DynamicInvariance, testing::ValuesIn(test::boundaries), test::by_words);

}  // namespace
}  // namespace breccia
