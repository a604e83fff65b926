#pragma once

#include <span>

namespace breccia {

/// A value without the error of its grids, and how far it may be off.
struct Extrapolated {
  double value = 0.0;
  double half_band = 0.0;  ///< in the unit of the value
};

/// The limit of vanishing cells of a value whose error is of first order in the cell side (theory, Eq. 21), from the
/// two finest of two or three grids, cell sides falling. From three grids the band is the difference to what the two
/// coarsest tell, at least a quarter of what the finest grid is corrected by; from two it is half of that correction.
/// Throws InputError for other than two or three grids, or cell sides that do not fall.
Extrapolated extrapolate(std::span<const double> cell_sides, std::span<const double> values);

}  // namespace breccia
