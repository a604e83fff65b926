// Tests of cubic arrays of spheres, rigid and elastic, against spectral elements that follow the sphere
// (tests/reference/rigid_cubic_arrays.csv, elastic_cubic_arrays.csv).

#include "breccia/microstructure/cubic_array.hpp"

#include <array>
#include <cmath>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/quasistatic/apparent_moduli.hpp"

#include "discretisation/mixed_cells.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr std::array tested_loads = {Load::bulk, Load::diagonal_shear, Load::shear};

struct Reference {
  Lattice lattice;
  double fraction;
  Moduli matrix, filler;         ///< [Pa]
  std::array<double, 3> moduli;  ///< K, (C11 - C12) / 2 and C44 [Pa]
};

std::ostream& operator<<(std::ostream& stream, const Reference& reference) {
  return stream << name_of(reference.lattice) << ", fraction " << reference.fraction << ", matrix K "
                << reference.matrix.bulk << ", G " << reference.matrix.shear;
}

std::vector<Reference> rigid_references() {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/rigid_cubic_arrays.csv", {"array"});
  std::vector<Reference> references;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto number = [&](const char* column) { return table.numbers(column)[row]; };
    const double bulk = number("matrix_K_over_G");
    references.push_back(
        {value_named<Lattice>(table.text("array")[row]).value(),
         number("fraction"),
         {.bulk = bulk, .shear = 1.0},
         {.bulk = 1e6 * bulk, .shear = 1e6},
         {bulk * number("K_over_matrix_K"), number("mu1_over_matrix_G"), number("C44_over_matrix_G")}});
  }
  return references;
}

/// The spheres of the table's first rows; the last row is another composite.
std::vector<Reference> elastic_references() {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/elastic_cubic_arrays.csv", {"case", "array"});
  std::vector<Reference> references;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto number = [&](const char* column) { return table.numbers(column)[row]; };
    const bool is_table_1 = table.text("case")[row] == "Table 1";
    references.push_back(
        {value_named<Lattice>(table.text("array")[row]).value(),
         number("fraction"),
         {.bulk = is_table_1 ? 1e6 : 62.5e9, .shear = number("matrix_shear_Pa")},
         is_table_1 ? Moduli{.bulk = 50e6, .shear = 18.8e6} : Moduli{.bulk = 222.222e9, .shear = 166.6667e9},
         {number("K_Pa"), number("mu1_Pa"), number("C44_Pa")}});
  }
  return references;
}

/// Relative errors of the three moduli with `cells` cells along each side.
std::array<double, 3> errors(const Reference& reference, int cells) {
  const double diameter = cubic_array_diameter(reference.lattice, 1.0, 1, reference.fraction);
  const auto box = cubic_array(reference.lattice, 1.0, 1, diameter);
  const std::vector<PhaseIndex> spheres(box.particles.size(), 1);
  const QuasistaticProblem<3> problem = {
      .discretisation = discretise_mixed(box, cells, 0, std::span<const PhaseIndex>(spheres), 2),
      .materials = {{"matrix", 1.0, PronySeries(reference.matrix.bulk), PronySeries(reference.matrix.shear)},
                    {"sphere", 1.0, PronySeries(reference.filler.bulk), PronySeries(reference.filler.shear)}},
      .boundary = Boundary::periodic};
  const auto moduli = apparent_moduli(problem, tested_loads);
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = moduli[i] / reference.moduli[i] - 1.0;
  return found;
}

void expect_within(const std::vector<Reference>& references, int cells, double tolerance) {
  for (const auto& reference : references) {
    const auto found = errors(reference, cells);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_LT(std::abs(found[i]), tolerance) << reference << ", " << name_of(tested_loads[i]) << ", " << found[i];
    }
  }
}

// The error is of the first order in the side of the cells, and 1 % with 64 cells.
TEST(CubicArrays, OfElasticSpheresAreWithinPercent) {
  expect_within(elastic_references(), 16, 0.04);
}

// The gaps of simple cubic arrays at 40 % are 1.4 cells wide.
TEST(CubicArrays, OfRigidSpheresAreWithinPercent) {
  expect_within(rigid_references(), 16, 0.07);
}

}  // namespace
}  // namespace breccia
