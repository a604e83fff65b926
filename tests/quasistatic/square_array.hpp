#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "tables/csv.hpp"

namespace breccia::test {

/// A periodic square array of discs whose modulus is known.
struct SquareArray {
  double fraction, contrast, bulk_ratio;
  Load load;
  double modulus;  ///< modulus over the shear modulus of the matrix
};

inline std::ostream& operator<<(std::ostream& stream, const SquareArray& array) {
  return stream << "fraction " << array.fraction << ", contrast " << array.contrast << ", K/G " << array.bulk_ratio
                << ", load " << static_cast<int>(array.load);
}

/// The periodic arrays of a table in tests/reference.
inline std::vector<SquareArray> periodic_square_arrays(const std::string& name) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/" + name, {"boundary", "load"});
  const std::map<std::string, Load> loads = {
      {"xy", Load::shear}, {"xx-yy", Load::diagonal_shear}, {"bulk", Load::bulk}};
  std::vector<SquareArray> arrays;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("boundary")[row] != "periodic") continue;
    arrays.push_back({table.numbers("fraction")[row], table.numbers("contrast")[row], table.numbers("bulk_ratio")[row],
                      loads.at(table.text("load")[row]), table.numbers("modulus")[row]});
  }
  return arrays;
}

/// Modulus of the array over the shear modulus of the matrix with n x n cells.
inline double found(const SquareArray& array, int n, Volumetric volumetric, Mixing mixing) {
  Microstructure<2> box = {1.0, Walls::periodic, {}};
  box.particles.push_back({{0.5, 0.5}, 2.0 * std::sqrt(array.fraction / std::numbers::pi)});
  const double filler = array.contrast;
  constexpr std::array<PhaseIndex, 1> disc = {1};
  const QuasistaticProblem<2> problem = {
      .discretisation = mixing == Mixing::points ? discretise(box, n, 0, 1) : discretise_mixed(box, n, 0, disc, 2),
      .materials = {{"matrix", 1.0, PronySeries(array.bulk_ratio), PronySeries(1.0)},
                    {"filler", 1.0, PronySeries(filler * 13.4 / 5.84), PronySeries(filler)}},
      .volumetric = volumetric,
      .boundary = Boundary::periodic};
  const Moduli matrix = {.bulk = array.bulk_ratio, .shear = 1.0};
  return sample_responses(problem, std::array{array.load}, matrix_path(0, std::array{matrix}))
      .responses[0]
      .modulus(matrix);
}

/// Relative error of the array with mixed cells.
inline double error_of_mixed_cells(const SquareArray& array, int n) {
  return found(array, n, Volumetric::averaged, Mixing::series) / array.modulus - 1.0;
}

}  // namespace breccia::test
