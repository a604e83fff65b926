#pragma once

#include <vector>

#include "breccia/microstructure/convex_cell.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia {

// The parts of mistakes(), for callers that have the cells. Instantiated for 2 and 3 dimensions.

/// Positions outside the box, weights that are not finite and shares of the films that are not positive. Throws
/// InputError if the box has no size, there are no sites or more than most_particles, or the numbers of shares and
/// sites differ.
template <int dim>
[[nodiscard]] std::vector<SiteMistake> mistakes_of_numbers(const LaguerreSites<dim>& sites);

/// The sites to which no point belongs.
template <int dim>
[[nodiscard]] std::vector<SiteMistake> empty_cells(const LaguerreSites<dim>& sites,
                                                   const std::vector<ConvexCell<dim>>& cells);

/// Throws InputError that lists the mistakes (up to twenty, sites counted from 1) if there are any.
void require_none(const std::vector<SiteMistake>& mistakes);

}  // namespace breccia
