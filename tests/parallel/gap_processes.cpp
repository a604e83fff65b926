// A test under mpirun: several processes find the moduli of a packing with gaps narrower than a cell, by factors and by
// substructuring. Known moduli: tests/reference/disc_packings/moduli.csv.

#include <array>
#include <cmath>
#include <cstdio>

#include "parallel/session.hpp"
#include "quasistatic/disc_packings.hpp"

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

bool moduli_are_those_of_conforming_elements() {
  struct Known {
    Load load;
    double modulus;
  };
  constexpr std::array<Known, 2> known = {{{Load::diagonal_shear, 23.6836035}, {Load::shear, 19.0474465}}};
  constexpr int cells = 61;
  auto problem = test::with_gaps(test::disc_packing("equal_57_040_g040.csv"), cells, 1e3, 1e7);
  bool holds = true;
  for (const auto& [load, modulus] : known) {
    problem.linear.method = LinearMethod::direct;
    const double direct = test::modulus_of(problem, load);
    problem.linear.method = LinearMethod::iterative;
    holds = expect_near(direct, modulus, 0.015, "factors") && holds;
    holds = expect_near(test::modulus_of(problem, load), direct, 1e-6, "substructuring") && holds;
  }
  return holds;
}

}  // namespace

int main() {
  breccia::parallel::start();
  const bool holds = moduli_are_those_of_conforming_elements();
  breccia::parallel::stop();
  return holds ? 0 : 1;
}
