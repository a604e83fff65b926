#include "quasistatic/solvers/lattice/fourier_transform.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "quasistatic/solvers/lattice/eigen_transform.hpp"
#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> some_values(std::size_t count) {
  std::vector<Complex> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i);
    values[i] = {std::sin(1.0 + 3.7 * x), std::cos(2.1 * x)};
  }
  return values;
}

/// The wave sum_j x_j exp(-+ 2 pi i j k / n).
Complex wave_of(const std::vector<Complex>& row, std::size_t k, WaveDirection direction) {
  const double sign = direction == WaveDirection::forward ? -1.0 : 1.0;
  Complex sum;
  for (std::size_t j = 0; j < row.size(); ++j) {
    sum += row[j] * std::polar(1.0, sign * 2.0 * std::numbers::pi * static_cast<double>(j * k % row.size()) /
                                        static_cast<double>(row.size()));
  }
  return sum;
}

struct Transforms {
  std::unique_ptr<WaveTransform> (*of_waves)(WaveDirection, const WaveRows&);
  std::unique_ptr<RealTransform> (*of_reals)(const RealRows&);
};

/// The transforms that the solvers use, and those that need no FFTW.
constexpr std::array<Transforms, 2> all_transforms = {
    {{wave_transform, real_transform}, {wave_transform_of_eigen, real_transform_of_eigen}}};

class FourierTransforms : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] static double rounding() { return 1e-14 * GetParam(); }
};

TEST_P(FourierTransforms, MeetTheirSums) {
  const int rows = 3, apart = 4, apart_after = 5;
  const auto length = static_cast<std::size_t>(GetParam());
  for (const auto& [of_waves, of_reals] : all_transforms) {
    for (const auto direction : {WaveDirection::forward, WaveDirection::backward}) {
      auto values = some_values(length * apart), in_place = values;
      std::vector<Complex> waves(length * apart_after);
      of_waves(direction, {GetParam(), rows, apart, apart_after, false})->apply(values.data(), waves.data());
      of_waves(direction, {GetParam(), rows, apart, apart, true})->apply(in_place.data(), in_place.data());
      for (std::size_t r = 0; r < rows; ++r) {
        std::vector<Complex> row(length);
        for (std::size_t j = 0; j < length; ++j) row[j] = some_values(length * apart)[r + j * apart];
        for (std::size_t k = 0; k < length; ++k) {
          const auto expected = wave_of(row, k, direction);
          EXPECT_LT(std::abs(waves[r + k * apart_after] - expected), rounding()) << "row " << r << ", wave " << k;
          EXPECT_LT(std::abs(in_place[r + k * apart] - expected), rounding()) << "row " << r << ", wave " << k;
        }
      }
    }
  }
}

TEST_P(FourierTransforms, OfRealRowsMeetTheirSumsAndGoBack) {
  const int rows = 3, width = 2 * (GetParam() / 2 + 1);
  const auto length = static_cast<std::size_t>(GetParam());
  for (const auto& [of_waves, of_reals] : all_transforms) {
    std::vector<double> values;
    for (const auto& value : some_values(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width)))
      values.push_back(value.real());
    const auto before = values;
    const auto transform = of_reals({GetParam(), rows, width});
    transform->apply(values.data());
    for (std::size_t r = 0; r < rows; ++r) {
      const auto begin = r * static_cast<std::size_t>(width);
      const std::vector<Complex> row(before.begin() + static_cast<std::ptrdiff_t>(begin),
                                     before.begin() + static_cast<std::ptrdiff_t>(begin + length));
      for (std::size_t k = 0; k <= length / 2; ++k) {
        const Complex wave(values[begin + 2 * k], values[begin + 2 * k + 1]);
        EXPECT_LT(std::abs(wave - wave_of(row, k, WaveDirection::forward)), rounding())
            << "row " << r << ", wave " << k;
      }
    }
    transform->apply_back(values.data());
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t j = 0; j < length; ++j) {
        const auto place = r * static_cast<std::size_t>(width) + j;
        EXPECT_NEAR(values[place], static_cast<double>(length) * before[place],
                    static_cast<double>(length) * rounding());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, FourierTransforms, testing::Values(1, 2, 3, 4, 5, 8, 12, 31, 45, 64, 97),
                         breccia::test::by_value);

TEST(FourierTransform, OfNothingIsRefused) {
  for (const auto& [of_waves, of_reals] : all_transforms) {
    EXPECT_THROW(of_waves(WaveDirection::forward, {0, 1, 1, 1, true}), NumericalError);
    EXPECT_THROW(of_reals({0, 1, 2}), NumericalError);
  }
}

}  // namespace
}  // namespace breccia::quasistatic
