// A test under mpirun: several processes find the same moduli of films in space by compressed and by full factors, and
// a matrix that compressed factors do not serve, or none do, fails on all of them.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "films/film_composite.hpp"
#include "films/grid_matrix.hpp"
#include "films/solver/compressed_factors.hpp"
#include "parallel/session.hpp"

namespace {

using namespace breccia;

bool expect(bool holds, const char* wrong) {
  if (!holds) std::puts(wrong);
  return holds;
}

bool moduli_are_those_of_full_factors() {
  RandomTessellationRequest request;
  request.side = 1e-3;
  request.diameters.assign(8, 1.0);
  const Tessellation<3> tessellation(random_sites<3>(request));
  const films::FilmComposite<3> composite({.tessellation = tessellation,
                                           .thickness = film_thickness(tessellation, 0.93),
                                           .grain = {.bulk = 13.4e9, .shear = 5.84e9},
                                           .elements = {.divisions = 1}});
  std::array<double, 2> moduli{};
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    films::FilmSolver<3> solver(composite, i == 0 ? 0 : std::numeric_limits<std::int64_t>::max());
    solver.prepare(std::array{1e6, 3.6e9});
    moduli[i] = solver.modulus(Load::shear, solver.solve(Load::shear, composite.zero()));
  }
  return expect(std::abs(moduli[0] / moduli[1] - 1.0) < 1e-9, "the moduli of compressed and full factors differ");
}

/// Whether the factors of a matrix that is known on the first process alone throw on all.
bool fails_together(bool throws_itself) {
  films::CompressedFactors factors(std::numeric_limits<double>::infinity());
  try {
    factors.factorise([&]() -> test::Sparse {
      if (throws_itself) throw NumericalError("no matrix");
      auto matrix = test::grid_matrix(1.0);
      matrix *= std::nan("");
      return matrix;
    });
    static_cast<void>(factors.solve(test::right_side(test::grid_matrix(1.0))));
  } catch (const NumericalError&) {
    return true;
  }
  return expect(false, throws_itself ? "a failure of the first process is not thrown" : "NaN is a solution");
}

}  // namespace

int main() {
  parallel::start();
  bool holds = moduli_are_those_of_full_factors();
  holds = fails_together(true) && holds;
  holds = fails_together(false) && holds;
  parallel::stop();
  return holds ? 0 : 1;
}
