#include "assessment/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

const std::vector<UncertainInput>& three_inputs() {
  static const std::vector<UncertainInput> inputs = {
      {"a", "Pa", Distribution(Normal{1.0, 0.1})},
      {"b", "", Distribution(Uniform{0.0, 1.0})},
      {"c", "", Choices{{std::int64_t{1}, std::int64_t{2}, std::int64_t{3}}}}};
  return inputs;
}

TEST(LatinHypercube, TakesEverySliceOnce) {
  constexpr Eigen::Index points = 12;
  const auto hypercube = latin_hypercube(three_inputs(), points, 1);
  ASSERT_EQ(hypercube.rows(), 3);
  ASSERT_EQ(hypercube.cols(), points);
  for (const Eigen::Index input : {0, 1}) {
    std::vector<double> shares;
    for (const double score : hypercube.row(input)) shares.push_back(normal_share(score));
    std::ranges::sort(shares);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      EXPECT_NEAR(shares[i], (static_cast<double>(i) + 0.5) / static_cast<double>(points), 1e-12);
    }
  }
  for (const double choice : {0.0, 1.0, 2.0}) {
    EXPECT_EQ(std::ranges::count(hypercube.row(2), choice), points / 3);
  }
}

TEST(LatinHypercube, IsTheSameForTheSameSeed) {
  EXPECT_EQ(latin_hypercube(three_inputs(), 20, 5), latin_hypercube(three_inputs(), 20, 5));
  EXPECT_NE(latin_hypercube(three_inputs(), 20, 5), latin_hypercube(three_inputs(), 20, 6));
}

TEST(LatinHypercube, ItsInputsHardlyCorrelate) {
  const auto hypercube = latin_hypercube(three_inputs(), 20, 2);
  const Eigen::VectorXd a = hypercube.row(0), b = hypercube.row(1);
  EXPECT_LT(std::abs(a.dot(b)) / (a.norm() * b.norm()), 0.15);
}

}  // namespace
}  // namespace breccia
