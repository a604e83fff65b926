// Spheres with gaps narrower than a cell (docs/gaps-in-space.md), against conforming elements.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/sphere_packings.hpp"

namespace breccia {
namespace {

// Gaps of 0.03 to 0.14 cells.
TEST(CubicArraysWithNarrowGaps, HaveTheModuliOfConformingElements) {
  const auto table = test::sphere_reference("cubic_arrays", {"array"});
  int found = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto& name = table.text("array")[row];
    const double gap = 0.01 * table.numbers("gap")[row];
    if (gap > 0.01) continue;
    const int cells = name == "sc" ? 12 : 16;
    const auto box = test::moved_by(test::cubic_array(name, gap), {0.36, 0.08, 0.21}, cells);
    const auto [diagonal, shear] = test::shear_moduli(test::spheres_with_gaps(box, cells));
    EXPECT_NEAR(diagonal / table.numbers("xx-yy")[row], 1.0, 0.06) << name << ' ' << gap;
    EXPECT_NEAR(shear / table.numbers("xy")[row], 1.0, 0.06) << name << ' ' << gap;
    ++found;
  }
  EXPECT_EQ(found, 6);
}

// Ten cells to a diameter, gaps from a tenth of a cell to many cells.
TEST(PackingsOfSpheres, HaveTheModuliOfConformingElementsWithinTenPercent) {
  const std::string name = "equal_52_008_a";
  const auto table = test::sphere_reference("moduli", {"packing", "load"});
  const auto [diagonal, shear] = test::shear_moduli(test::spheres_with_gaps(test::sphere_packing(name), 20));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("packing")[row] != name) continue;
    const double expected = table.numbers("modulus")[row];
    const auto& load = table.text("load")[row];
    if (load == "xx-yy" || load == "xy") {
      EXPECT_NEAR((load == "xy" ? shear : diagonal) / expected, 1.0, 0.1) << load;
    }
  }
}

TEST(SpheresWithGaps, MovedByWholeCellsAreTheSame) {
  const auto array = test::cubic_array("fcc", 0.02);
  constexpr int cells = 12;
  const auto here = test::spheres_with_gaps(test::moved_by(array, {0.3, 0.1, 0.2}, cells), cells, 1e3),
             there = test::spheres_with_gaps(test::moved_by(array, {4.3, 7.1, 2.2}, cells), cells, 1e3);
  EXPECT_NEAR(test::shear_moduli(here)[1] / test::shear_moduli(there)[1], 1.0, 1e-6);
}

// A sphere on the sides of the box: the gaps of the last slab of cells, the third of three, are those of the first.
TEST(SpheresWithGaps, ExertTheSameForcesForAnyNumberOfThreads) {
  const auto problem = test::spheres_with_gaps(test::moved_by(test::cubic_array("fcc", 0.02), {0.3, 0.1, 0.2}, 11), 11);
  const std::array<Moduli, 2> moduli = {{{.bulk = 1e5, .shear = 1.0}, {.bulk = 1e4, .shear = 1e3}}};
  const auto forces_of = [&](int threads) {
    const quasistatic::ElasticOperator<3> elastic_operator(problem.discretisation, Volumetric::averaged,
                                                           Boundary::periodic, threads, {}, problem.materials);
    auto moved = elastic_operator.uniform_strain(Load::shear);
    moved.add(0.1, quasistatic::forces_under(elastic_operator, moduli, moved, unit_strain<3>(Load::shear)));
    const auto forces = quasistatic::forces_under(elastic_operator, moduli, moved, unit_strain<3>(Load::shear));
    PetscInt size = 0;
    quasistatic::check(VecGetLocalSize(forces.fluctuation(), &size), "reading the size of a vector");
    const quasistatic::ReadValues values(forces.fluctuation());
    return std::vector<double>(values.data(), values.data() + size);
  };
  const auto expected = forces_of(1);
  EXPECT_GT(expected.size(), std::size_t{3 * 11 * 11 * 11});
  for (const int threads : {2, 3}) EXPECT_EQ(forces_of(threads), expected);
}

TEST(SpheresWithGaps, HaveFieldsThatAverageToTheCurve) {
  auto problem = test::spheres_with_gaps(test::moved_by(test::cubic_array("sc", 0.02), {0.3, 0.1, 0.2}, 10), 10);
  problem.materials = test::random_composite(4, 1, Boundary::periodic).materials;
  problem.materials.resize(2);
  const auto& binder = problem.materials.front();
  for (const auto load : {Load::shear, Load::diagonal_shear}) {
    const auto found =
        sample_responses(problem, std::array{load}, matrix_path(0, carson_path(binder, test::relaxation_window)));
    const double time = 1e-4;
    const auto fields = found.fields(0, std::array{binder}, time);
    double stress = 0.0, strain = 0.0;
    for (std::size_t i = 0; i < fields.stress.size(); ++i) {
      const auto& of_stress = fields.stress[i];
      const auto& of_strain = fields.strain[i];
      const bool is_shear = load == Load::shear;
      stress += is_shear ? of_stress[5] : 0.5 * (of_stress[0] - of_stress[1]);
      strain += is_shear ? 2.0 * of_strain[5] : of_strain[0] - of_strain[1];
    }
    const double modulus = relaxation_modulus(creep_compliance(found.responses[0], binder)).at(time);
    EXPECT_NEAR(stress / strain / modulus, 1.0, 1e-6) << name_of(load);
  }
}

TEST(SpheresWithGaps, UnderAnotherBoundaryThanAPeriodicOneAreRefused) {
  auto box = test::cubic_array("sc", 0.1);
  box.walls = Walls::hard;
  box.particles.front().centre = {0.5, 0.5, 0.5};
  auto problem = test::spheres_with_gaps(box, 8);
  problem.boundary = Boundary::displacement;
  EXPECT_THROW((void)test::shear_moduli(problem), InputError);
}

}  // namespace
}  // namespace breccia
