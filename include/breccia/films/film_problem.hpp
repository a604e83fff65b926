#pragma once

#include <optional>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// The model of grains and films in plane strain (theory, section 17): elastic grains, the cells of a tessellation of a
/// plane, with films of binder between them that have one thickness, or one for each pair of grains
/// (LaguerreSites::film_shares). A periodic boundary requires a periodic tessellation; the other boundaries require
/// hard walls. Walls cut grains and films like a window in a larger body; no film runs along a wall.
struct FilmProblem {
  Tessellation<2> tessellation;
  double thickness = 0.0;  ///< thickness of the films [m]; where they have shares, of a film with a mean share of one
  Moduli grain = {};       ///< moduli of the grains [Pa]
  Boundary boundary = Boundary::periodic;
  /// Ratio of the longest element along a face to the square root of the area of the smaller grain beside it [-]. With
  /// 0.3 most faces have two elements.
  double face_share = 0.3;
  /// Number of layers of elements that resolve the binder across every film (theory, Eq. 66a). If absent, films are
  /// thin and have one row of elements each.
  std::optional<int> layers = {};
};

/// Throws InputError with all mistakes: a thickness, a share, a modulus or a number of layers that is not positive, or
/// a boundary that does not fit the walls of the tessellation.
void require_sound(const FilmProblem& problem);

}  // namespace breccia
