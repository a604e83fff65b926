// Tests of square arrays of discs against conforming finite elements (tests/reference/elastic_square_array.csv).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

struct Reference {
  double fraction, contrast, bulk_ratio;
  Load load;
  double modulus;  ///< modulus over the shear modulus of the matrix
};

std::ostream& operator<<(std::ostream& stream, const Reference& reference) {
  return stream << "fraction " << reference.fraction << ", contrast " << reference.contrast << ", K/G "
                << reference.bulk_ratio << ", load " << static_cast<int>(reference.load);
}

std::vector<Reference> periodic_references() {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/elastic_square_array.csv", {"boundary", "load"});
  const std::map<std::string, Load> loads = {
      {"xy", Load::shear}, {"xx-yy", Load::diagonal_shear}, {"bulk", Load::bulk}};
  std::vector<Reference> references;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("boundary")[row] != "periodic") continue;
    references.push_back({table.numbers("fraction")[row], table.numbers("contrast")[row],
                          table.numbers("bulk_ratio")[row], loads.at(table.text("load")[row]),
                          table.numbers("modulus")[row]});
  }
  return references;
}

/// Modulus of the array over the shear modulus of the matrix with n x n cells.
double found(const Reference& reference, int n, Volumetric volumetric, Mixing mixing = Mixing::points) {
  Microstructure<2> box = {1.0, Walls::periodic, {}};
  box.particles.push_back({{0.5, 0.5}, 2.0 * std::sqrt(reference.fraction / std::numbers::pi)});
  const double filler = reference.contrast;
  constexpr std::array<PhaseIndex, 1> disc = {1};
  const QuasistaticProblem<2> problem = {
      .discretisation = mixing == Mixing::points ? discretise(box, n, 0, 1) : discretise_mixed(box, n, 0, disc, 2),
      .materials = {{"matrix", 1.0, PronySeries(reference.bulk_ratio), PronySeries(1.0)},
                    {"filler", 1.0, PronySeries(filler * 13.4 / 5.84), PronySeries(filler)}},
      .volumetric = volumetric,
      .boundary = Boundary::periodic};
  const Moduli matrix = {.bulk = reference.bulk_ratio, .shear = 1.0};
  return sample_responses(problem, std::array{reference.load}, matrix_path(0, std::array{matrix}))
      .responses[0]
      .modulus(matrix);
}

struct Errors {
  double coarse, fine;  ///< relative errors with 64 and 128 cells
  [[nodiscard]] double extrapolated() const { return 2.0 * fine - coarse; }
};

Errors errors(const Reference& reference, Volumetric volumetric) {
  return {found(reference, 64, volumetric) / reference.modulus - 1.0,
          found(reference, 128, volumetric) / reference.modulus - 1.0};
}

bool is_nearly_incompressible(const Reference& reference) {
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

/// Relative error of the array with mixed cells.
double error_of_mixed_cells(const Reference& reference, int n) {
  return found(reference, n, Volumetric::averaged, Mixing::series) / reference.modulus - 1.0;
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
    EXPECT_GT(found(reference, 64, Volumetric::standard), 1.1 * found(reference, 64, Volumetric::averaged))
        << reference;
  }
}

}  // namespace
}  // namespace breccia
