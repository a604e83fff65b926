#pragma once

#include <array>
#include <utility>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_problem.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "microstructure/voronoi_sites_25.hpp"

namespace breccia::test {

inline constexpr Moduli hmx = {.bulk = 13.4e9, .shear = 5.84e9};
inline constexpr double binder_bulk = 3.6e9;
inline constexpr double film_of_25 = 2.4 / 256.0;  ///< thickness with which 25 grains fill 91.11 % of the unit square
inline constexpr std::array all_loads = {Load::shear, Load::diagonal_shear, Load::bulk};
inline constexpr std::array all_boundaries = {Boundary::displacement, Boundary::traction, Boundary::periodic};

/// The modulus that a load measures in one material [Pa].
inline double modulus_of(const Moduli& moduli, Load load) {
  return load == Load::bulk ? moduli.bulk + moduli.shear / 3.0 : moduli.shear;
}

/// A binder that relaxes in shear over eight decades, and in volume.
inline Material relaxing_binder() {
  return {"binder", 1.0, PronySeries(3e9, {{1e-4, 0.6e9}}),
          PronySeries(4e5, {{1e-7, 8e8}, {1e-5, 1.5e8}, {1e-3, 2e7}, {1e-1, 2e6}})};
}

/// The 25 sites of the reference, in a periodic box or as a window that the walls cut.
inline FilmProblem<2> voronoi_problem(Boundary boundary = Boundary::periodic, double thickness = film_of_25) {
  auto sites = voronoi_sites_25();
  if (boundary != Boundary::periodic) sites.walls = Walls::hard;
  return {
      .tessellation = Tessellation<2>(std::move(sites)), .thickness = thickness, .grain = hmx, .boundary = boundary};
}

}  // namespace breccia::test
