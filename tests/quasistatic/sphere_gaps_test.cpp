// Spheres with gaps narrower than a cell (docs/gaps-in-space.md), against conforming elements.

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/operator/cube_forces.hpp"
#include "quasistatic/operator/vector_values.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

const std::string sphere_references = BRECCIA_REFERENCE_DIRECTORY "/sphere_packings/";

/// The box, moved by shares of a cell.
Microstructure<3> moved_by(Microstructure<3> box, const Vector<3>& cells, int n) {
  for (auto& sphere : box.particles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sphere.centre[axis] = std::fmod(sphere.centre[axis] + cells[axis] / n + 1.0, 1.0);
    }
  }
  return box;
}

Microstructure<3> cubic_array(const std::string& name, double gap) {
  Microstructure<3> box = {1.0, Walls::periodic, {}};
  double distance = 1.0;
  std::vector<Vector<3>> places = {{0.0, 0.0, 0.0}};
  if (name == "bcc") {
    distance = std::sqrt(0.75);
    places.push_back({0.5, 0.5, 0.5});
  } else if (name == "fcc") {
    distance = std::sqrt(0.5);
    places.insert(places.end(), {{0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}});
  }
  for (const auto& place : places) box.particles.push_back({place, distance / (1.0 + gap)});
  return box;
}

Microstructure<3> sphere_packing(const std::string& name) {
  const auto table = read_csv(sphere_references + name + ".csv", {});
  const auto &x = table.numbers("x"), &y = table.numbers("y"), &z = table.numbers("z");
  Microstructure<3> box = {1.0, Walls::periodic, {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    box.particles.push_back({{x[i], y[i], z[i]}, table.numbers("diameter")[i]});
  }
  return box;
}

/// Stiff spheres with gaps in a binder with a shear modulus of 1 and a bulk modulus of 1e5.
QuasistaticProblem<3> spheres_with_gaps(const Microstructure<3>& box, int n, double contrast = 1e7) {
  const std::vector<PhaseIndex> spheres(box.particles.size(), 1);
  QuasistaticProblem<3> problem = {.discretisation = discretise_mixed(box, n, 0, spheres, 2),
                                   .materials = {{"binder", 1.0, PronySeries(1e5), PronySeries(1.0)},
                                                 {"spheres", 1.0, PronySeries(10.0 * contrast), PronySeries(contrast)}},
                                   .volumetric = Volumetric::averaged,
                                   .boundary = Boundary::periodic};
  problem.linear.method = LinearMethod::direct;
  problem.discretisation.set_particles_with_gaps(std::make_shared<const ParticlesInBox<3>>(
      ParticlesInBox<3>{box, 0, std::vector<ParticlePhases>(spheres.size(), {.phase = 1})}));
  return problem;
}

/// The moduli under a diagonal shear and a shear.
std::array<double, 2> shear_moduli(const QuasistaticProblem<3>& problem) {
  const Moduli binder = {.bulk = 1e5, .shear = 1.0};
  const auto found =
      sample_responses(problem, std::array{Load::diagonal_shear, Load::shear}, matrix_path(0, std::array{binder}));
  return {found.responses[0].modulus(binder), found.responses[1].modulus(binder)};
}

// Gaps of 0.03 to 0.14 cells.
TEST(CubicArraysWithNarrowGaps, HaveTheModuliOfConformingElements) {
  const auto table = read_csv(sphere_references + "cubic_arrays.csv", {"array"});
  int found = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto& name = table.text("array")[row];
    const double gap = 0.01 * table.numbers("gap")[row];
    if (gap > 0.01) continue;
    const int cells = name == "sc" ? 12 : 16;
    const auto box = moved_by(cubic_array(name, gap), {0.36, 0.08, 0.21}, cells);
    const auto [diagonal, shear] = shear_moduli(spheres_with_gaps(box, cells));
    EXPECT_NEAR(diagonal / table.numbers("xx-yy")[row], 1.0, 0.06) << name << ' ' << gap;
    EXPECT_NEAR(shear / table.numbers("xy")[row], 1.0, 0.06) << name << ' ' << gap;
    ++found;
  }
  EXPECT_EQ(found, 6);
}

// Ten cells to a diameter, gaps from a tenth of a cell to many cells.
TEST(PackingsOfSpheres, HaveTheModuliOfConformingElementsWithinTenPercent) {
  const std::string name = "equal_52_008_a";
  const auto table = read_csv(sphere_references + "moduli.csv", {"packing", "load"});
  const auto [diagonal, shear] = shear_moduli(spheres_with_gaps(sphere_packing(name), 20));
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
  const auto array = cubic_array("fcc", 0.02);
  constexpr int cells = 12;
  const auto here = spheres_with_gaps(moved_by(array, {0.3, 0.1, 0.2}, cells), cells, 1e3),
             there = spheres_with_gaps(moved_by(array, {4.3, 7.1, 2.2}, cells), cells, 1e3);
  EXPECT_NEAR(shear_moduli(here)[1] / shear_moduli(there)[1], 1.0, 1e-6);
}

// A sphere on the sides of the box: the gaps of the last slab of cells, the third of three, are those of the first.
TEST(SpheresWithGaps, ExertTheSameForcesForAnyNumberOfThreads) {
  const auto problem = spheres_with_gaps(moved_by(cubic_array("fcc", 0.02), {0.3, 0.1, 0.2}, 11), 11);
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
  auto problem = spheres_with_gaps(moved_by(cubic_array("sc", 0.02), {0.3, 0.1, 0.2}, 10), 10);
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
  auto box = cubic_array("sc", 0.1);
  box.walls = Walls::hard;
  box.particles.front().centre = {0.5, 0.5, 0.5};
  auto problem = spheres_with_gaps(box, 8);
  problem.boundary = Boundary::displacement;
  EXPECT_THROW((void)shear_moduli(problem), InputError);
}

}  // namespace
}  // namespace breccia
