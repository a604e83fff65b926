#include "quasistatic/solvers/lattice/wall_transform.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

/// The sine wave 2 sum_j x_j sin(pi j k / n).
double sine_wave(const std::vector<double>& row, std::size_t k) {
  const std::size_t n = row.size() - 1;
  double sum = 0.0;
  for (std::size_t j = 1; j < n; ++j) {
    sum += 2.0 * row[j] * std::sin(std::numbers::pi * static_cast<double>(j * k) / static_cast<double>(n));
  }
  return sum;
}

/// The cosine wave x_0 + (-1)^k x_n + 2 sum_j x_j cos(pi j k / n).
double cosine_wave(const std::vector<double>& row, std::size_t k) {
  const std::size_t n = row.size() - 1;
  double sum = row.front() + (k % 2 == 0 ? 1.0 : -1.0) * row.back();
  for (std::size_t j = 1; j < n; ++j) {
    sum += 2.0 * row[j] * std::cos(std::numbers::pi * static_cast<double>(j * k) / static_cast<double>(n));
  }
  return sum;
}

/// A plane of rows, with a value behind each row that is not touched.
struct Plane {
  Plane(std::size_t rows, std::size_t nodes) : width(nodes + 1), values(rows * width) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(1.0 + 3.7 * static_cast<double>(i));
  }
  [[nodiscard]] std::vector<double> row(std::size_t number) const {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(number * width);
    return {begin, begin + static_cast<std::ptrdiff_t>(width - 1)};
  }

  std::size_t width;
  std::vector<double> values;
};

class WallTransforms : public testing::TestWithParam<int> {
 protected:
  static void meet_their_sums(WallTransform::Kind kind, int cells, std::size_t rows) {
    const auto nodes = static_cast<std::size_t>(cells) + 1;
    const Plane before(rows, nodes);
    auto after = before;
    const WallTransform transform(kind, cells, (rows + 1) / 2);
    const auto waves = transform.make_waves();
    transform.apply({.first = after.values.data(),
                     .apart = 1,
                     .partner = after.width,
                     .pairs = (rows + 1) / 2,
                     .distance = 2 * after.width,
                     .is_last_alone = rows % 2 == 1},
                    waves.get());
    for (std::size_t number = 0; number < rows; ++number) {
      for (std::size_t k = 0; k < nodes; ++k) {
        const auto row = before.row(number);
        const double expected = kind == WallTransform::Kind::sine ? sine_wave(row, k) : cosine_wave(row, k);
        EXPECT_NEAR(after.row(number)[k], expected, 1e-12 * cells) << cells << ", row " << number << ", wave " << k;
      }
      const auto behind = number * before.width + nodes;
      EXPECT_EQ(after.values[behind], before.values[behind]);
    }
  }
};

TEST_P(WallTransforms, MeetTheirSums) {
  for (const std::size_t rows : {1U, 2U, 5U}) {
    meet_their_sums(WallTransform::Kind::sine, GetParam(), rows);
    meet_their_sums(WallTransform::Kind::cosine, GetParam(), rows);
  }
}

TEST_P(WallTransforms, AreTheirOwnInversesButForAFactor) {
  const int cells = GetParam();
  const auto nodes = static_cast<std::size_t>(cells) + 1;
  // Two rows side by side: neighbours are a pair.
  std::vector<double> values(2 * nodes);
  for (std::size_t i = 2; i + 2 < values.size(); ++i) values[i] = std::cos(2.3 * static_cast<double>(i));
  for (const auto kind : {WallTransform::Kind::sine, WallTransform::Kind::cosine}) {
    const WallTransform transform(kind, cells, 1);
    const auto waves = transform.make_waves();
    auto twice = values;
    const PairedRows rows = {
        .first = twice.data(), .apart = 2, .partner = 1, .pairs = 1, .distance = 2, .is_last_alone = false};
    transform.apply(rows, waves.get());
    // Waves at both ends stand for themselves and their opposites.
    transform.apply(rows, waves.get());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(twice[i], 2.0 * cells * values[i], 1e-11 * cells);
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, WallTransforms, testing::Values(1, 2, 3, 5, 8, 12, 31), breccia::test::by_value);

}  // namespace
}  // namespace breccia::quasistatic
