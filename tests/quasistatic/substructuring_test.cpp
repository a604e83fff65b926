#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

constexpr std::array loads = {Load::shear, Load::bulk};

/// Elastic moduli of a composite, by load, and the cost of the solution.
struct Solved {
  std::vector<double> moduli;
  LinearEffort effort;
};

Solved solved(QuasistaticProblem<2> problem, LinearMethod method, const Moduli& matrix) {
  problem.linear.method = method;
  const auto sampled = sample_responses(problem, loads, matrix_path(0, std::array{matrix}));
  Solved solved = {{}, sampled.effort};
  for (const auto& response : sampled.responses) solved.moduli.push_back(response.modulus(matrix));
  return solved;
}

class Substructuring : public testing::TestWithParam<std::tuple<Boundary, Volumetric>> {
 protected:
  [[nodiscard]] static QuasistaticProblem<2> composite(int cells, std::uint64_t seed) {
    auto problem = test::random_composite(cells, seed, std::get<Boundary>(GetParam()));
    problem.volumetric = std::get<Volumetric>(GetParam());
    return problem;
  }
};

TEST_P(Substructuring, AgreesWithCholeskyFactorsForAnyContrastInFewIterations) {
  constexpr double filler_shear = 5.84e9;
  std::uint64_t seed = 10;
  for (const int cells : {32, 37}) {  // numbers of cells that can and cannot be divided evenly
    const auto problem = composite(cells, seed++);
    for (const double contrast : {1.0, 1e2, 1e5}) {
      for (const double bulk_over_shear : {3.0, 3600.0}) {
        const Moduli matrix = {bulk_over_shear * filler_shear / contrast, filler_shear / contrast};
        const auto direct = solved(problem, LinearMethod::direct, matrix);
        const auto iterative = solved(problem, LinearMethod::iterative, matrix);
        for (std::size_t l = 0; l < loads.size(); ++l) {
          EXPECT_NEAR(iterative.moduli[l] / direct.moduli[l], 1.0, 1e-8)
              << cells << " cells, contrast " << contrast << ", K/G " << bulk_over_shear;
        }
        EXPECT_FALSE(iterative.effort.is_direct);
        EXPECT_LE(iterative.effort.most_iterations, 60)
            << cells << " cells, contrast " << contrast << ", K/G " << bulk_over_shear;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, Substructuring,
                         testing::Combine(testing::ValuesIn(test::boundaries),
                                          testing::Values(Volumetric::averaged, Volumetric::standard)),
                         test::by_words);

// The solution for nearly the same moduli is the guess for the second system, so that three decades of ten remain.
TEST(SubstructuringWithAGuess, TakesFewIterationsUnderEveryBoundary) {
  constexpr std::array shear = {Load::shear};
  const Moduli matrix = {3.6e9, 1e6}, nearly = {3.6e9, 1.0000001e6};
  for (const auto boundary : test::boundaries) {
    auto problem = test::random_composite(32, 10, boundary);
    problem.linear.method = LinearMethod::iterative;
    const auto iterations = [&](const std::vector<Moduli>& training_set) {
      return sample_responses(problem, shear, matrix_path(0, training_set), {.tolerance = 1.0}).effort.iterations;
    };
    const int first = iterations({matrix}), both = iterations({nearly, matrix});
    EXPECT_LT(2 * (both - first), first) << name_of(boundary);
  }
}

TEST(SubstructuringOnThreads, GivesTheSameBitsForAnyNumber) {
  const Moduli matrix = {3.6e9, 1e6};
  auto problem = test::random_composite(200, 3, Boundary::periodic);
  problem.linear.threads = 1;
  const auto one = solved(problem, LinearMethod::iterative, matrix);
  problem.linear.threads = 3;
  EXPECT_EQ(solved(problem, LinearMethod::iterative, matrix).moduli, one.moduli);
}

TEST(SubstructuringOfAHomogeneousBox, GivesItsModuliHoweverFewItsCells) {
  const Moduli matrix = {3e9, 1e9};
  const Material material = {"solid", 1000.0, PronySeries(matrix.bulk), PronySeries(matrix.shear)};
  for (const auto boundary : test::boundaries) {
    for (const int columns : {1, 2, 3, 9, 13}) {
      for (const int rows : {1, 4, 17}) {
        const QuasistaticProblem<2> problem = {.discretisation = Discretisation<2>(Grid<2>{{columns, rows}, 1e-3}),
                                               .materials = {material},
                                               .boundary = boundary};
        const auto [moduli, effort] = solved(problem, LinearMethod::iterative, matrix);
        EXPECT_NEAR(moduli[0] / matrix.shear, 1.0, 1e-9) << columns << " x " << rows;
        EXPECT_NEAR(moduli[1] / (matrix.bulk + matrix.shear / 3.0), 1.0, 1e-9) << columns << " x " << rows;
      }
    }
  }
}

}  // namespace
}  // namespace breccia
