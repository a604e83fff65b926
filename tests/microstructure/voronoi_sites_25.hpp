#pragma once

#include "breccia/microstructure/laguerre_sites.hpp"

#include "tables/csv.hpp"

namespace breccia::test {

/// The sites of tests/reference/voronoi_sites_25.csv.
inline LaguerreSites<2> voronoi_sites_25() {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/voronoi_sites_25.csv");
  LaguerreSites<2> sites{1.0, Walls::periodic, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sites.sites.push_back({{table.numbers("x_m")[row], table.numbers("y_m")[row]}, table.numbers("weight_m2")[row]});
  }
  return sites;
}

}  // namespace breccia::test
