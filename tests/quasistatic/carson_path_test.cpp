#include "quasistatic/reduced/carson_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"

namespace breccia {
namespace {

const TimeWindow window = {1e-3, 1e-1};

Material with_shear(PronySeries shear) {
  return {"m", 1000.0, PronySeries(2e9), std::move(shear)};
}

TEST(CarsonModuli, AreThoseOfAMaxwellElement) {
  const auto moduli = carson_moduli(with_shear(PronySeries(1e6, {{1e-2, 3e6}})), 50.0);
  EXPECT_DOUBLE_EQ(moduli.shear, 1e6 + 3e6 * 0.5 / 1.5);
  EXPECT_DOUBLE_EQ(moduli.bulk, 2e9);
}

TEST(RelaxationPath, GoesFromUnrelaxedToRelaxedWhateverTheWindow) {
  const PronySeries bulk(1e9, {{1e2, 5e8}});
  const Material material = {"m", 1000.0, bulk, PronySeries(1e5, {{1e-9, 1e9}, {1e-2, 1e7}, {1e6, 1e6}})};
  const auto path = relaxation_path(material, window);
  EXPECT_DOUBLE_EQ(path.front().shear, 1.0111e9);
  EXPECT_DOUBLE_EQ(path.front().bulk, 1.5e9);
  EXPECT_DOUBLE_EQ(path.back().shear, 1e5);
  EXPECT_DOUBLE_EQ(path.back().bulk, 1e9);
  // A Carson modulus falls no faster than the Laplace variable, of which there are eight a decade.
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT(path[i].shear, path[i - 1].shear);
    EXPECT_GT(path[i].shear, path[i - 1].shear * std::pow(10.0, -1.0 / 8.0) * 0.95);
  }
}

TEST(RelaxationPath, OfWhatFlowsEndsTwoDecadesBeyondOrWhereTheWindowDoes) {
  // G s tau / (1 + s tau) at s tau = 1/100, and at s = 1 / (30 x 100 s).
  const auto material = with_shear(PronySeries(0.0, {{1e-2, 5e5}}));
  EXPECT_NEAR(relaxation_path(material, {1e-4, 1e-3}).back().shear / (5e5 * 0.01 / 1.01), 1.0, 1e-12);
  EXPECT_NEAR(relaxation_path(material, {1e-4, 1e2}).back().shear / (5e5 / 3e5 * 1.0 / (1.0 + 1.0 / 3e5)), 1.0, 1e-9);
}

// Of a constant Poisson's ratio both moduli relax to zero, which are those of a void.
TEST(RelaxationPath, OfWhatFlowsInShearAndInBulkHasNoPointWithoutStiffness) {
  const PronySeries shear(0.0, {{1.0, 1e6}});
  const auto path = relaxation_path({"paste", 2000.0, shear.scaled(4.0 / 3.0), shear}, window);
  EXPECT_GT(path.back().shear, 0.0);
  EXPECT_NEAR(path.back().bulk / path.back().shear, 4.0 / 3.0, 1e-12);
}

TEST(RelaxationPath, OfAnElasticMaterialIsAPoint) {
  const auto path = relaxation_path(with_shear(PronySeries(3e6)), window);
  ASSERT_EQ(path.size(), 1U);
  EXPECT_EQ(path.front().shear, 3e6);
}

TEST(RelaxationPath, OfSeveralMaterialsIsTakenAtEqualLaplaceVariables) {
  const std::vector materials = {with_shear(PronySeries(1e5, {{1e-9, 1e9}})),
                                 with_shear(PronySeries(1e6, {{1e3, 1e6}})), with_shear(PronySeries(5e9))};
  const auto path = relaxation_path(materials, window);
  EXPECT_TRUE(std::isinf(path.front().laplace_variable));
  EXPECT_EQ(path.back().laplace_variable, 0.0);
  EXPECT_EQ(path.front().moduli[1].shear, 2e6);
  EXPECT_EQ(path.back().moduli[0].shear, 1e5);
  for (const auto& [s, moduli] : path) {
    ASSERT_EQ(moduli.size(), 3U);
    for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(moduli[m].shear, carson_moduli(materials[m], s).shear) << s;
  }
  // The moduli of every material change as smoothly as on a path of its own, where the material relaxes and where
  // another one does.
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT(path[i].laplace_variable, path[i - 1].laplace_variable);
    for (std::size_t m = 0; m < 3; ++m) EXPECT_GT(path[i].moduli[m].shear, 0.7 * path[i - 1].moduli[m].shear);
  }
}

TEST(RelaxationPath, HoldsWhatTheMaterialShowsAtAnyTemperature) {
  const auto material = with_shear(PronySeries(1e5, {{1e-6, 1e9}, {1e-2, 1e7}, {1e3, 1e6}}));
  const auto path = relaxation_path(material, window);
  for (const double factor : {1e-12, 1e-4, 1e3, 1e12}) {
    for (const auto& moduli : carson_path(shifted(material, factor), window)) {
      EXPECT_LE(moduli.shear, path.front().shear * (1.0 + 1e-12)) << factor;
      EXPECT_GE(moduli.shear, path.back().shear * (1.0 - 1e-12)) << factor;
    }
  }
}

/// The composite with an elastic matrix, without any reduction: a single solution.
double solved(const QuasistaticProblem<2>& problem, Load load, const Moduli& matrix) {
  return sample_responses(problem, std::array{load}, matrix_path(0, std::array{matrix}))
      .responses.front()
      .modulus(matrix);
}

/// Expects responses that are sampled over the path of their matrix to meet the tolerance everywhere on it.
void expect_good_all_along(const QuasistaticProblem<2>& problem) {
  const std::array loads = {Load::shear, Load::bulk};
  const auto path = relaxation_path(problem.materials.front(), {1e-7, 1e-3});
  const auto responses = sample_responses(problem, loads, matrix_path(0, path)).responses;
  for (std::size_t i = 0; i < path.size(); i += path.size() / 9) {
    for (std::size_t l = 0; l < loads.size(); ++l) {
      const double exact = solved(problem, loads[l], path[i]);
      EXPECT_NEAR(responses[l].modulus(path[i]) / exact, 1.0, 1.5e-5) << path[i].shear;
    }
  }
}

TEST(RelaxationPath, SamplesACompositeFromUnrelaxedToRelaxed) {
  for (const auto boundary : test::boundaries) {
    auto problem = test::random_composite(20, 8, boundary);
    auto& matrix = problem.materials.front();
    expect_good_all_along(problem);
    matrix.shear = PronySeries(0.0, {{1e-13, 1e9}, {1e-6, 8e7}, {1e-3, 1e6}, {1e4, 4e3}});
    expect_good_all_along(problem);
    matrix.shear = PronySeries(1.0, {{1e-13, 1e9}, {1e-6, 8e7}, {1e-3, 1e6}, {1e4, 4e3}});
    expect_good_all_along(problem);
    matrix.bulk = PronySeries(1e8, {{3e-7, 2e9}, {2e-5, 1e9}});
    expect_good_all_along(problem);
  }
}

}  // namespace
}  // namespace breccia
