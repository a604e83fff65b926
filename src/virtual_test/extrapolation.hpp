#pragma once

#include <span>
#include <vector>

namespace breccia {

/// A value extrapolated to vanishing cell size, with its error band.
struct Extrapolated {
  double value = 0.0;
  double half_band = 0.0;  ///< half width of the error band, in the unit of the value
};

/// The limit of vanishing cells of a value whose error is of first order in the cell side (theory, Eq. 21), from its
/// values on two or three grids with falling cell sides [m]. The two finest grids give the limit. With three grids the
/// half band is the difference between that limit and the limit from the two coarsest grids, but at least a quarter of
/// the correction of the finest grid's value; with two grids it is half of that correction.
/// Throws InputError for other than two or three grids, or cell sides that do not fall.
Extrapolated extrapolate(std::span<const double> cell_sides, std::span<const double> values);

/// The largest relative error of the finer of two grids up to each time [-], estimated from the change of a curve from
/// the coarser one (theory, Eq. 43): an error of first order in the cell side is the change over `ratio` - 1, where
/// `ratio` is the number of cells of the finer grid over that of the coarser one; a ratio beyond 2 counts as 2. Both
/// curves have the same times, in rising order. Throws InputError when their lengths differ, or for a ratio of 1 and
/// less.
std::vector<double> largest_errors(std::span<const double> coarse, std::span<const double> fine, double ratio);

}  // namespace breccia
