#pragma once

#include <optional>

#include "breccia/discretisation/mixture.hpp"

namespace breccia {

/// The largest relative error [-] to be expected of the moduli of a stage on one grid with this many cells in its
/// narrowest gap: an empirical rule (theory, Eq. 43a). Nothing where a gap has so few cells that the error may be of
/// any size.
std::optional<double> expected_grid_error(Mixing mixing, double cells_per_gap);

/// Cells in the narrowest gap [-] on a grid from which no more than this relative error [-] is to be expected.
double cells_per_gap_for(Mixing mixing, double error);

/// The same for mixed cells and the films between grains, which carry the load of the whole stage (theory, Eq. 43b).
std::optional<double> expected_film_error(double cells_per_film);
double cells_per_film_for(double error);

/// The same for mixed cells and random packings of spheres that fill a fraction of the box [-], by the cells across the
/// sphere of the mean diameter: all volume over all surface, times six (theory, Eq. 43c). Nothing close to jamming.
std::optional<double> expected_sphere_error(double cells_per_diameter, double fraction);
/// Nothing for fractions close to jamming.
std::optional<double> cells_per_diameter_for(double error, double fraction);
/// Was the rule of spheres measured about this fraction [-], or is it extrapolated to it?
bool is_sphere_error_measured(double fraction);

}  // namespace breccia
