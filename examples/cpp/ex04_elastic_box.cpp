// Example 4: the apparent elastic moduli of one box under three boundary conditions, beside the bounds that follow from
// the volume fractions alone.

#include <array>

#include <fmt/format.h>

#include "breccia/discretisation/phases.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/quasistatic/apparent_moduli.hpp"
#include "breccia/virtual_test/modulus_bounds.hpp"

using breccia::Boundary;
using breccia::Load;

int main() {
  // Forty discs of 1 mm in a periodic box of 8 mm; a cell is 80 um wide and holds 2 x 2 material points.
  breccia::PackingRequest request;
  request.side = 8e-3;
  request.walls = breccia::Walls::periodic;
  request.diameters.assign(40, 1e-3);
  request.minimum_gap = 0.16e-3;
  request.seed = 1;
  const breccia::Microstructure<2> box = {request.side, request.walls, breccia::pack<2>(request).balls};
  constexpr int cells = 100;
  // A material point belongs to one of the phases, which have names, and a phase is of one material.
  const breccia::Phases phases({"matrix", "filler"});
  const auto matrix = phases.index_of("matrix"), filler = phases.index_of("filler");
  const auto discretisation = breccia::discretise(box, cells, matrix, filler);

  // Name, density [kg/m^3], bulk modulus K and shear modulus G [Pa].
  const breccia::Material epoxy = {"epoxy", 1200.0, breccia::PronySeries(4.0e9), breccia::PronySeries(1.3e9)};
  const breccia::Material glass = {"glass", 2500.0, breccia::PronySeries(40.0e9), breccia::PronySeries(30.0e9)};
  const auto materials = phases.materials({{"matrix", epoxy}, {"filler", glass}});

  const auto fractions = discretisation.fractions(phases.size());
  const double voigt = fractions[matrix] * 1.3e9 + fractions[filler] * 30.0e9;
  const double reuss = 1.0 / (fractions[matrix] / 1.3e9 + fractions[filler] / 30.0e9);
  const breccia::ShearModulusBounds hashin(discretisation, materials);

  const auto moduli_under = [&](Boundary boundary) {
    return breccia::apparent_moduli<2>({.discretisation = discretisation, .materials = materials, .boundary = boundary},
                                       std::array{Load::shear, Load::bulk});
  };
  const auto kubc = moduli_under(Boundary::displacement);
  const auto periodic = moduli_under(Boundary::periodic);
  const auto subc = moduli_under(Boundary::traction);

  fmt::print("{:.1f} % glass in epoxy, in plane strain\n\n", 100.0 * fractions[filler]);
  fmt::print("{:24}  {:>8}  {:>14}\n", "", "G [GPa]", "K + G/3 [GPa]");
  fmt::print("{:24}  {:8.3f}\n", "Voigt", voigt / 1e9);
  fmt::print("{:24}  {:8.3f}\n", "Hashin, upper", hashin.upper(0.0) / 1e9);
  fmt::print("{:24}  {:8.3f}  {:14.3f}\n", "this box, KUBC", kubc[0] / 1e9, kubc[1] / 1e9);
  fmt::print("{:24}  {:8.3f}  {:14.3f}\n", "this box, periodic", periodic[0] / 1e9, periodic[1] / 1e9);
  fmt::print("{:24}  {:8.3f}  {:14.3f}\n", "this box, SUBC", subc[0] / 1e9, subc[1] / 1e9);
  fmt::print("{:24}  {:8.3f}\n", "Hashin, lower", hashin.lower(0.0) / 1e9);
  fmt::print("{:24}  {:8.3f}\n", "Reuss", reuss / 1e9);

  // The order of one and the same box is exact (Huet 1990); Voigt's and Reuss's moduli enclose every box.
  const bool is_ordered = reuss < subc[0] && subc[0] < periodic[0] && periodic[0] < kubc[0] && kubc[0] < voigt &&
                          subc[1] < periodic[1] && periodic[1] < kubc[1];
  fmt::print("\nReuss < SUBC < periodic < KUBC < Voigt: {}\n", is_ordered ? "yes" : "no");
  return is_ordered ? 0 : 1;
}
