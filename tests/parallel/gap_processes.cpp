// A test under mpirun: several processes find the moduli of packings with gaps narrower than a cell, by factors and, in
// the plane, by substructuring. Known moduli: tests/reference/disc_packings/moduli.csv and moduli_walls.csv,
// sphere_packings/cubic_arrays.csv.

#include <array>
#include <cmath>
#include <cstdio>
#include <span>

#include "parallel/session.hpp"
#include "quasistatic/disc_packings.hpp"
#include "quasistatic/sphere_packings.hpp"

namespace {

using breccia::LinearMethod;
using breccia::Load;
namespace test = breccia::test;

/// Prints the mistake unless the numbers are equal within a share of them.
bool expect_near(double found, double expected, double share, const char* what) {
  if (std::abs(found / expected - 1.0) < share) return true;
  std::printf("%s: %.9g instead of %.9g\n", what, found, expected);
  return false;
}

struct Known {
  Load load;
  double modulus;
};

bool moduli_are(std::span<const Known> known, breccia::QuasistaticProblem<2> problem, double share) {
  bool holds = true;
  for (const auto& [load, modulus] : known) {
    problem.linear.method = LinearMethod::direct;
    const double direct = test::modulus_of(problem, load);
    problem.linear.method = LinearMethod::iterative;
    holds = expect_near(direct, modulus, share, "factors") && holds;
    holds = expect_near(test::modulus_of(problem, load), direct, 1e-6, "substructuring") && holds;
  }
  return holds;
}

bool moduli_are_those_of_conforming_elements() {
  constexpr std::array<Known, 2> of_periodic = {{{Load::diagonal_shear, 23.6836035}, {Load::shear, 19.0474465}}};
  constexpr std::array<Known, 1> of_walls = {{{Load::shear, 109.149474}}},
                                 under_tractions = {{{Load::shear, 6.85995709}}};
  const auto periodic = test::with_gaps(test::disc_packing("equal_57_040_g040.csv"), 61, 1e3, 1e7);
  auto walls = test::with_gaps(test::disc_packing_between_walls("walls_four_g100.csv"), 33, 1e3, 1e7);
  bool holds = moduli_are(of_periodic, periodic, 0.015);
  holds = moduli_are(of_walls, walls, 0.015) && holds;
  walls.boundary = breccia::Boundary::traction;
  return moduli_are(under_tractions, walls, 0.015) && holds;
}

bool moduli_of_spheres_are_those_of_conforming_elements() {
  constexpr int cells = 12;
  const auto box = test::moved_by(test::cubic_array("bcc", 0.01), {0.36, 0.08, 0.21}, cells);
  const auto [diagonal, shear] = test::shear_moduli(test::spheres_with_gaps(box, cells));
  return expect_near(shear, 70.186, 0.03, "spheres, xy") && expect_near(diagonal, 8.563, 0.08, "spheres, xx-yy");
}

}  // namespace

int main() {
  breccia::parallel::start();
  const bool of_discs = moduli_are_those_of_conforming_elements();
  const bool holds = moduli_of_spheres_are_those_of_conforming_elements() && of_discs;
  breccia::parallel::stop();
  return holds ? 0 : 1;
}
