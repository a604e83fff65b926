#pragma once

#include <span>
#include <vector>

#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia {

/// Weights of sites, and the error of the volumes of their cells.
struct SiteWeights {
  std::vector<double> weights;  ///< weights [m^2], by site
  double largest_error = 0.0;   ///< largest relative difference of a cell's volume from the wanted one [-]
  int steps = 0;                ///< number of steps of Newton's method
};

/// The weights for which the volumes (in 2D the areas) of the cells are in the proportion of `volumes`, whose unit does
/// not matter. They exist and are unique but for a number added to all (theory, Eq. 50). The search begins with the
/// weights that the sites have, or with equal ones if these leave a cell empty, and ends when largest_error is at most
/// `tolerance`. Throws InputError if there is not one positive volume for each site, if the sites have a mistake that
/// no weights can correct, or if the tolerance is not positive; NumericalError if the search does not converge because
/// of roundoff. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] SiteWeights weights_for_volumes(const LaguerreSites<dim>& sites, std::span<const double> volumes,
                                              double tolerance = 1e-9);

}  // namespace breccia
