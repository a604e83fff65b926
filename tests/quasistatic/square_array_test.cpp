// Tests of square arrays of discs against conforming finite elements (tests/reference/elastic_square_array.csv).

#include "quasistatic/square_array.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

using test::error_of_mixed_cells;
using test::found;
using test::periodic_square_arrays;
using test::SquareArray;

std::vector<SquareArray> periodic_references() {
  return periodic_square_arrays("elastic_square_array.csv");
}

struct Errors {
  double coarse, fine;  ///< relative errors with 64 and 128 cells
  [[nodiscard]] double extrapolated() const { return 2.0 * fine - coarse; }
};

Errors errors(const SquareArray& reference, Volumetric volumetric) {
  return {found(reference, 64, volumetric, Mixing::points) / reference.modulus - 1.0,
          found(reference, 128, volumetric, Mixing::points) / reference.modulus - 1.0};
}

bool is_nearly_incompressible(const SquareArray& reference) {
  return reference.bulk_ratio > 100.0;
}

TEST(SquareArray, AveragedPointsConvergeToConformingFiniteElementsAtFirstOrder) {
  double orders = 0.0;
  int count = 0;
  for (const auto& reference : periodic_references()) {
    const auto error = errors(reference, Volumetric::averaged);
    EXPECT_LT(std::abs(error.extrapolated()), 0.016) << reference;
    // Where filler and matrix are almost equally stiff, the error is too small to determine its order.
    if (error.fine < 1e-3) continue;
    orders += std::log2(error.coarse / error.fine);
    ++count;
  }
  // The interface is sampled at points: the order of a single array scatters with the area fraction that is sampled.
  EXPECT_NEAR(orders / count, 1.1, 0.2);
}

// The error is a tenth of that of points on the same grid (theory, section 2).
TEST(SquareArray, MixedCellsAreWithinPercentOnCoarseGrids) {
  struct Limits {
    int cells;
    double median, worst;
  };
  for (const auto& [cells, median, worst] :
       {Limits{16, 0.006, 0.16}, Limits{32, 0.0035, 0.055}, Limits{64, 0.003, 0.04}}) {
    std::vector<double> errors;
    for (const auto& reference : periodic_references()) {
      errors.push_back(std::abs(error_of_mixed_cells(reference, cells)));
      EXPECT_LT(errors.back(), worst) << reference << ", " << cells << " cells";
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], median) << cells << " cells";
  }
}

TEST(SquareArray, StandardPointsAgreeWhereTheMatrixIsCompressible) {
  for (const auto& reference : periodic_references()) {
    if (is_nearly_incompressible(reference)) continue;
    EXPECT_LT(std::abs(errors(reference, Volumetric::standard).extrapolated()), 0.018) << reference;
  }
}

TEST(SquareArray, StandardPointsLockWhereItIsNot) {
  for (const auto& reference : periodic_references()) {
    if (!is_nearly_incompressible(reference) || reference.load != Load::diagonal_shear) continue;
    EXPECT_GT(found(reference, 64, Volumetric::standard, Mixing::points),
              1.1 * found(reference, 64, Volumetric::averaged, Mixing::points))
        << reference;
  }
}

}  // namespace
}  // namespace breccia
