#pragma once

#include <array>
#include <utility>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_problem.hpp"

#include "microstructure/voronoi_sites_25.hpp"

namespace breccia::test {

inline constexpr Moduli hmx = {.bulk = 13.4e9, .shear = 5.84e9};
inline constexpr double binder_bulk = 3.6e9;
inline constexpr double film_of_25 = 2.4 / 256.0;  ///< with which 25 grains fill 91.11 % of the unit square
inline constexpr std::array all_loads = {Load::shear, Load::diagonal_shear, Load::bulk};
/// The modulus of a material that a load measures [Pa].
inline double modulus_of(const Moduli& moduli, Load load) {
  return load == Load::bulk ? moduli.bulk + moduli.shear / 3.0 : moduli.shear;
}

inline constexpr std::array all_boundaries = {Boundary::displacement, Boundary::traction, Boundary::periodic};

/// The 25 sites of the reference, in a periodic box or as a window that the walls cut.
inline FilmProblem voronoi_problem(Boundary boundary = Boundary::periodic, double thickness = film_of_25) {
  auto sites = voronoi_sites_25();
  if (boundary != Boundary::periodic) sites.walls = Walls::hard;
  return {
      .tessellation = Tessellation<2>(std::move(sites)), .thickness = thickness, .grain = hmx, .boundary = boundary};
}

}  // namespace breccia::test
